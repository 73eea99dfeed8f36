// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief encodes an image as an uncompressed TIFF file, with libtiff
 *
 * The pixels are stored unchanged: bytes or 32-bit floats, 1, 3 or 4 channels, the top row first,
 * in strips of about 64 KiB. The fourth of four bytes is straight alpha; the fourth of four floats
 * has no defined meaning. vtkTIFFWriter would declare premultiplied alpha, and does not report
 * write errors.
 *
 * Equal images give equal files, in the byte order of the machine.
 *
 * Limit: the pixels must take less than 4 GiB, because offsets have 32 bits.
 */

#ifndef EncodeTiff_h
#define EncodeTiff_h

#include <vector>

class vtkImageData;

namespace lambent::command
{

/// Returns the bytes of a file with the image's scalars. Throws Failure if TIFF cannot hold them.
std::vector<unsigned char> EncodeTiff(vtkImageData* image);

} // namespace lambent::command

#endif
