// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the image of `--background-image`
 *
 * PNG files are read by vtkLambentPNGReader, VTK's images after a check of their XML, PNM by
 * ReadPnm(), TIFF by libtiff. VTK's readers for JPEG and BMP trust the file, and a TIFF can ask for
 * any amount of memory, so these three are read in a child process (see Isolated.h).
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
