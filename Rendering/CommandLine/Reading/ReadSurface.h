// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the surface in a file of any supported format
 */

#ifndef ReadSurface_h
#define ReadSurface_h

#include "Contour.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <optional>
#include <string>

class vtkDataObject;
class vtkPolyData;

namespace lambent::command
{

class Progress;
class VtkMessages;

/**
 * Returns the polygons in a file, the outer surface of its volume cells, or with `contour` the
 * surface on which an array of a volume has a given value. The blocks of a file are appended to one
 * surface. The result is valid: every cell names existing points.
 *
 * Throws Failure if the file cannot be read completely. VTK's readers often return a part of a
 * truncated file; any error that they report is a Failure here. Warns if there are no polygons,
 * unless the points are drawn.
 */
vtkSmartPointer<vtkPolyData> ReadSurface(const std::string& path, VtkMessages& messages,
  Progress& progress, const std::optional<ContourValue>& contour = std::nullopt,
  bool drawsPoints = false);

/// Returns what `convert` makes of the data in a file. Throws Failure like ReadSurface().
vtkSmartPointer<vtkPolyData> ReadAs(const std::string& path, VtkMessages& messages,
  Progress& progress, const std::function<vtkSmartPointer<vtkPolyData>(vtkDataObject*)>& convert);

} // namespace lambent::command

#endif
