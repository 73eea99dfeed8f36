// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief encodes an image as an uncompressed TIFF file, with libtiff
 *
 * The pixels are stored as they are: bytes or 32-bit floats, 1, 3 or 4 of them, the top row first,
 * in strips of about 64 KiB. The fourth of four bytes is alpha, straight; that of four floats has
 * no meaning of its own. vtkTIFFWriter would declare alpha to be multiplied into the colours, and
 * misses write errors.
 *
 * Equal images give equal files, in the byte order of the machine.
 *
 * Limit: the pixels must be smaller than 4 GiB, because offsets have 32 bits.
 */

#ifndef EncodeTiff_h
#define EncodeTiff_h

#include <vector>

class vtkImageData;

namespace lambent::command
{

/// The bytes of the file of the image's scalars. Throws Failure if they are of another form.
std::vector<unsigned char> EncodeTiff(vtkImageData* image);

} // namespace lambent::command

#endif
