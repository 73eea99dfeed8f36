// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the faces of a polydata, checked, with its strips as triangles
 */
#ifndef FacesFromVTK_h
#define FacesFromVTK_h

#include "CheckedFaces.h"
#include "SpansFromVTK.h"

#include <string>

class vtkPolyData;

namespace lambent::adapters
{
class FacesFromVTK
{
public:
  /// The polydata must outlive this object. Throws std::runtime_error, with the remedy in its
  /// message, if a cell uses a point that does not exist.
  FacesFromVTK(vtkPolyData* polyData, const Parallel& parallel);

  const Faces& faces() const { return this->Checked.faces; }
  /// Also true if all strips are too short to contain a triangle.
  bool hasStrips() const { return !this->Checked.merged.isEmpty(); }

  /// A message about the cells that are ignored because of coordinates that are not finite; empty
  /// if there are none.
  const std::string& warning() const { return this->Warning; }

  /// The cell that a face belongs to, counted from the first polygon.
  std::int64_t cellOf(std::int64_t face) const { return this->Checked.cellOf(face); }

  /// From now on use the points and polygons of `rewritten`, the same mesh after a rewrite.
  void refer(vtkPolyData* rewritten, const Parallel& parallel);

private:
  SpansFromVTK Spans;
  CheckedFaces Checked;
  std::string Warning;
};
}

#endif
