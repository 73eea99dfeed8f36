// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads binary PNM images: grey (P5) and RGB (P6), of 8 or 16 bits
 *
 * vtkPNMReader ignores the largest value, so that 16 bits become noise, and loops forever if the
 * header is incomplete.
 */

#ifndef ReadPnm_h
#define ReadPnm_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace lambent::command
{

/// Returns an image of floats from 0 to 1, or of bytes if the largest value is 255. Throws Failure.
vtkSmartPointer<vtkImageData> ReadPnm(const std::string& path);

} // namespace lambent::command

#endif
