// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief pictures as files whose bytes are the picture's
 *
 * PFM (floats) and PPM (bytes): a line of header and the channels as they are, so
 * that what differs can be looked at with any viewer.
 */
#ifndef PictureFile_h
#define PictureFile_h

#include "Drawing.h"

/// DIRECTORY/NAME.pfm and DIRECTORY/NAME.ppm. Throws std::runtime_error.
void writePicture(const Picture& picture, const std::string& directory, const std::string& name);

#endif
