// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief from a .png or .vti file to the image in it
 */

#ifndef ReadPicture_h
#define ReadPicture_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace lambent::command
{

class VtkMessages;

/// Throws Failure if the file is not there or not whole, or is no picture.
vtkSmartPointer<vtkImageData> ReadPicture(const std::string& path, VtkMessages& messages);

} // namespace lambent::command

#endif
