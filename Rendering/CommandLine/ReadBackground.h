// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the image of `--background-image`
 *
 * vtkLambentPNGReader reads PNG files, ReadPnm() reads PNM, libtiff reads TIFF, and VTK reads its
 * own images after a check of their XML. VTK's readers for JPEG and BMP trust the file, and a TIFF
 * file can request any amount of memory, so these three are read in a child process (see
 * Isolated.h).
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

/// Returns an image with one slice. Its pixels are bytes, or floats if the file has more than 8
/// bits: unsigned shorts are divided by 65535, and floats and doubles are not scaled. Throws
/// Failure if the file cannot be read completely, or has pixels of another type.
vtkSmartPointer<vtkImageData> ReadBackground(
  const std::string& path, VtkMessages& messages, Progress& progress);

} // namespace lambent::command

#endif
