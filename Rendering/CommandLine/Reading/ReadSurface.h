// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief from a mesh file of any kind to its surface
 */

#ifndef ReadSurface_h
#define ReadSurface_h

#include "Contour.h"

#include "vtkSmartPointer.h"

#include <optional>
#include <string>

class vtkPolyData;

namespace lambent::command
{

class Progress;
class VtkMessages;

/**
 * The polygons in a file, the outer surface of the volume cells in it, or with
 * `contour` the surface on which an array of a volume has a value. The blocks of
 * a file with many are one surface. What is returned is sound: every cell names
 * points that exist.
 *
 * Throws Failure if the file cannot be read whole. VTK's readers often return
 * what they have got so far from a file that is cut short; any error they
 * report on the way counts here as a failure.
 */
vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& path, VtkMessages& messages,
  Progress& progress, const std::optional<ContourValue>& contour = std::nullopt);

} // namespace lambent::command

#endif
