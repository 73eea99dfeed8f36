// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief how many triangles a mesh is drawn as, and a warning if there are none
 */

#ifndef CheckPolygons_h
#define CheckPolygons_h

#include "vtkType.h"

class vtkDataObject;
class vtkPolyData;

namespace lambent::command
{

/// A polygon or strip of n points is n - 2 triangles; one of fewer than 3 points is none.
vtkIdType CountTriangles(vtkPolyData* mesh);

/// Warns if there are none: nothing of the mesh will be seen. Says what there is instead. The data
/// are those that the mesh is the surface of: a surface has not all of their points.
void CheckPolygons(vtkPolyData* mesh, vtkDataObject* data);

} // namespace lambent::command

#endif
