// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief writes an image to a file of any supported kind
 */

#ifndef WritePicture_h
#define WritePicture_h

#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

class vtkImageData;
class vtkUnsignedCharArray;

namespace lambent::command
{

class VtkMessages;

/// Keys and texts stored in a PNG file.
using PictureText = std::vector<std::pair<std::string, std::string>>;

/// Throws Failure if a picture cannot be written there. Called before rendering.
void CheckPicturePlace(const std::string& path);

/**
 * Writes the image in the format of the path's extension; "-" is PNG to standard output. The text
 * is written to PNG files only. If Failure is thrown, an existing file is unchanged.
 */
void WritePicture(vtkImageData* image, const std::string& path, VtkMessages& messages,
  const PictureText& text = {});

/// The image as the bytes of a PNG file. Throws Failure.
vtkSmartPointer<vtkUnsignedCharArray> EncodePng(
  vtkImageData* image, VtkMessages& messages, const PictureText& text = {});

} // namespace lambent::command

#endif
