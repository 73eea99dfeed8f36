// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * @brief the vertices of a PLY file
 */

#ifndef PlyVertices_h
#define PlyVertices_h

#include <functional>

class vtkPolyData;

namespace lambent::command
{

class PlyCursor;
struct PlyElement;

/// Gives the mesh the points, and the normals if there are any; float stays float, double double.
void ReadPlyVertices(PlyCursor& cursor, const PlyElement& element,
  const std::function<void(double)>& progress, vtkPolyData* mesh);

} // namespace lambent::command

#endif
