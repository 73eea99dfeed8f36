// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief write pictures to files without changing their bits
 *
 * PFM (floats) and PPM (bytes) have a header and the unchanged channels, and many viewers
 * can show them when pictures differ. With alpha, they are PFM with four channels and PAM. All
 * passes are in one file: for each pass a line with its name and form, followed by its values, the
 * least significant byte first.
 */
#ifndef PictureFile_h
#define PictureFile_h

#include "Drawing.h"

/// Writes DIRECTORY/NAME.pfm, .ppm or .pam, and .passes if there are any. Throws std::runtime_error
/// on failure.
void writePicture(const Picture& picture, const std::string& directory, const std::string& name);

#endif
