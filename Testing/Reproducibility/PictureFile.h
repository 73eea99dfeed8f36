// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief write pictures to files without changing their bits
 *
 * PFM (floats) and PPM (bytes) have a header and the unchanged channels, and many viewers
 * can show them when pictures differ.
 */
#ifndef PictureFile_h
#define PictureFile_h

#include "Drawing.h"

/// Writes DIRECTORY/NAME.pfm and DIRECTORY/NAME.ppm. Throws std::runtime_error on failure.
void writePicture(const Picture& picture, const std::string& directory, const std::string& name);

#endif
