// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief from an image to a file of any kind
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

/// Keys and texts that a PNG file holds beside the picture.
using PictureText = std::vector<std::pair<std::string, std::string>>;

/// Throws Failure if a picture surely cannot be written there; known before it is drawn.
void CheckPicturePlace(const std::string& path);

/**
 * Writes the image in the kind that the name tells; "-" is PNG to standard
 * output. The text goes into PNG, others have no place for it. The file is there
 * whole or, if Failure is thrown, as it was before.
 */
void WritePicture(vtkImageData* image, const std::string& path, VtkMessages& messages,
  const PictureText& text = {});

/// The image as the bytes of a PNG file. Throws Failure.
vtkSmartPointer<vtkUnsignedCharArray> EncodePng(
  vtkImageData* image, VtkMessages& messages, const PictureText& text = {});

} // namespace lambent::command

#endif
