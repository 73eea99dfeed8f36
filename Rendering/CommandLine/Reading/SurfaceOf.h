// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief extracts one surface from a data object
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
 * Polygons are returned unchanged. Grids give their outer surface (vtkDataSetSurfaceFilter), or
 * their contour if one is requested. Composite data gives the surfaces of all blocks, in order and
 * contours last (vtkAppendPolyData); empty blocks are skipped, and only the arrays that all
 * surfaces have are kept. Images need a contour, since their outer surface is of no use.
 *
 * Throws Failure if the data has no mesh, or if a cell uses a point that does not exist.
 */
vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataObject* data,
  const std::optional<ContourValue>& contour, VtkMessages& messages, Progress& progress);

} // namespace lambent::command

#endif
