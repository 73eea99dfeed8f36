// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief from any data object that a reader returns to one surface
 */

#ifndef SurfaceOf_h
#define SurfaceOf_h

#include "Contour.h"

#include "vtkSmartPointer.h"

#include <optional>

class vtkDataObject;
class vtkPolyData;

namespace lambent::command
{

/**
 * Polygons as they are; the outer surface of grids (vtkDataSetSurfaceFilter),
 * or their contour if one is asked for; of composite data the surfaces of all
 * blocks in their order (vtkAppendPolyData), where empty blocks are skipped and
 * only the arrays that all of them have are kept. Images have no outer surface
 * worth drawing: they need a contour.
 *
 * Throws Failure if there is no mesh in it, or if a cell names a point that
 * does not exist.
 */
vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataObject* data,
  const std::optional<ContourValue>& contour, VtkMessages& messages, Progress& progress);

} // namespace lambent::command

#endif
