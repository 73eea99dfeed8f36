// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief counts the triangles of a mesh, and warns if it shows nothing
 */

#ifndef CheckPolygons_h
#define CheckPolygons_h

#include "vtkType.h"

class vtkDataObject;
class vtkPolyData;

namespace lambent::command
{

/// A polygon or strip of n points has n - 2 triangles, and none if n < 3.
vtkIdType CountTriangles(vtkPolyData* mesh);

/// Warns if the mesh has no triangles, lines or vertices, and says what it holds
/// instead. `data` is the data set whose surface the mesh is; it may have more points.
void CheckPolygons(vtkPolyData* mesh, vtkDataObject* data);

} // namespace lambent::command

#endif
