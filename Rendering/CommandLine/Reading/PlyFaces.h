// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * @brief reads the faces and triangle strips of a PLY file
 */

#ifndef PlyFaces_h
#define PlyFaces_h

#include <functional>

class vtkPolyData;

namespace lambent::command
{

class PlyCursor;
struct PlyElement;

/// Sets the polygons of the mesh from the element "face", with ids of 32 or 64 bits.
void ReadPlyFaces(PlyCursor& cursor, const PlyElement& element, bool idsAreShort,
  const std::function<void(double)>& progress, vtkPolyData* mesh);

/// Sets the strips of the mesh from the element "tristrips", which is usually a single list where
/// -1 ends each strip. Strips of fewer than 3 points are skipped with a warning.
void ReadPlyStrips(PlyCursor& cursor, const PlyElement& element,
  const std::function<void(double)>& progress, vtkPolyData* mesh);

} // namespace lambent::command

#endif
