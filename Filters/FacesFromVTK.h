// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the faces of a polydata: checked, and strips as triangles
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
  /// The polydata must outlive this object. Throws std::runtime_error, with what to
  /// do about it, if a cell names a point that does not exist.
  FacesFromVTK(vtkPolyData* polyData, const Parallel& parallel);

  const Faces& faces() const { return this->Checked.faces; }
  /// Also if they are all too short to have a triangle.
  bool hasStrips() const { return !this->Checked.merged.isEmpty(); }

  /// How many cells count for nothing because of coordinates that are not finite;
  /// empty if none.
  const std::string& warning() const { return this->Warning; }

  /// The cell, counted from the first polygon, that a face is of.
  std::int64_t cellOf(std::int64_t face) const { return this->Checked.cellOf(face); }

  /// From now on take points and polygons from the same mesh after a rewrite.
  void refer(vtkPolyData* rewritten, const Parallel& parallel);

private:
  SpansFromVTK Spans;
  CheckedFaces Checked;
  std::string Warning;
};
}

#endif
