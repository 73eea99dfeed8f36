// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the image of `--background-image`
 *
 * PNG files are read by vtkLambentPNGReader, VTK's images after a check of their XML, PNM by
 * ReadPnm(). VTK's readers for JPEG, TIFF and BMP trust the file, so they run in a child process
 * (see Isolated.h), after a check of what they would read wrongly (see CheckImage.h).
 */

#ifndef ReadBackground_h
#define ReadBackground_h

#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;

namespace lambent::command
{

class Progress;
class VtkMessages;

/// An image of one slice of bytes, or of floats for what has more than 8 bits: unsigned shorts are
/// divided by 65535, floats and doubles are taken as they are. Throws Failure if the file cannot be
/// read completely, or its pixels are of another form.
vtkSmartPointer<vtkImageData> ReadBackground(
  const std::string& path, VtkMessages& messages, Progress& progress);

} // namespace lambent::command

#endif
