// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the first image of a TIFF file with libtiff
 *
 * Grey and RGB, with or without alpha, with 8 or 16 bits or floats, keep their values if they are
 * stored in rows. Everything else that libtiff supports, such as palettes, CMYK, YCbCr, tiles,
 * separate planes and premultiplied alpha, becomes 8-bit RGBA. vtkTIFFReader ignores most of these
 * properties, garbles colours of 16 and 32 bits, and inverts alpha.
 */

#ifndef ReadTiff_h
#define ReadTiff_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace lambent::command
{

/// Returns an image of one slice, the bottom row first. Throws Failure if it cannot be read.
vtkSmartPointer<vtkImageData> ReadTiff(const std::string& path);

} // namespace lambent::command

#endif
