// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * @brief reads the vertices of a PLY file
 */

#ifndef PlyVertices_h
#define PlyVertices_h

#include <functional>

class vtkPolyData;

namespace lambent::command
{

class PlyCursor;
struct PlyElement;

/// Sets the points of the mesh, and the normals if there are any. Coordinates keep their precision,
/// float or double; normals are float.
void ReadPlyVertices(PlyCursor& cursor, const PlyElement& element,
  const std::function<void(double)>& progress, vtkPolyData* mesh);

} // namespace lambent::command

#endif
