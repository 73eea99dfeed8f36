// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief refuses TIFF and BMP files that VTK's readers would read wrongly
 *
 * vtkTIFFReader garbles colours of 16 and 32 bits and grey with alpha, inverts alpha, and ignores
 * the orientation. vtkBMPReader ignores compression and missing rows. The accepted files are read
 * correctly: TIFF in strips with 8 bits per channel, or grey with 16 bits or floats; BMP without
 * compression.
 */

#ifndef CheckImage_h
#define CheckImage_h

#include <string>

namespace lambent::command
{

/// Throws Failure unless vtkTIFFReader reads the file correctly, apart from the order of rows and
/// inverted alpha, which the caller must correct.
void CheckTiff(const std::string& path);

/// Throws Failure unless vtkBMPReader reads the file correctly.
void CheckBmp(const std::string& path);

} // namespace lambent::command

#endif
