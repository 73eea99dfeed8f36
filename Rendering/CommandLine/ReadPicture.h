// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads a .png or .vti file
 */

#ifndef ReadPicture_h
#define ReadPicture_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace lambent::command
{

class VtkMessages;

/// Throws Failure if the file is missing, incomplete or not a picture.
vtkSmartPointer<vtkImageData> ReadPicture(const std::string& path, VtkMessages& messages);

} // namespace lambent::command

#endif
