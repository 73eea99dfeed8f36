// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the first image of a TIFF file, with libtiff
 *
 * Grey and RGB, with or without alpha, of 8 or 16 bits or floats, keep their numbers if they are
 * stored in rows. Everything else that libtiff knows, such as palettes, CMYK, YCbCr, tiles,
 * separate planes and multiplied alpha, becomes RGBA of 8 bits. vtkTIFFReader ignores most of these
 * properties, mixes up colours of 16 and 32 bits, and inverts alpha.
 */

#ifndef ReadTiff_h
#define ReadTiff_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace lambent::command
{

/// Throws Failure.
vtkSmartPointer<vtkImageData> ReadTiff(const std::string& path);

} // namespace lambent::command

#endif
