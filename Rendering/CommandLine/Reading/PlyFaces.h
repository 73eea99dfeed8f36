// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * @brief the faces and triangle strips of a PLY file
 */

#ifndef PlyFaces_h
#define PlyFaces_h

#include <functional>

class vtkPolyData;

namespace lambent::command
{

class PlyCursor;
struct PlyElement;

/// Gives the mesh polygons from the element "face"; their ids are of 32 bits or of 64.
void ReadPlyFaces(PlyCursor& cursor, const PlyElement& element, bool idsAreShort,
  const std::function<void(double)>& progress, vtkPolyData* mesh);

/// Gives the mesh strips from the element "tristrips". It is one list, mostly, in which -1 ends a
/// strip. Strips of fewer than 3 points are left out, and a warning counts them.
void ReadPlyStrips(PlyCursor& cursor, const PlyElement& element,
  const std::function<void(double)>& progress, vtkPolyData* mesh);

} // namespace lambent::command

#endif
