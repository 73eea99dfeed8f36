// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief from a mesh file of any kind to its surface
 */

#ifndef ReadSurface_h
#define ReadSurface_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

namespace lambent::command
{

class Progress;
class VtkMessages;

/**
 * The polygons in a file, or the outer surface of the volume cells in it. What
 * is returned is sound: every cell names points that exist.
 *
 * Throws Failure if the file cannot be read whole. VTK's readers often return
 * what they have got so far from a file that is cut short; any error they
 * report on the way counts here as a failure.
 */
vtkSmartPointer<vtkPolyData> ReadSurface(
  const std::string& path, VtkMessages& messages, Progress& progress);

} // namespace lambent::command

#endif
