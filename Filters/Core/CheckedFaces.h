// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief polygons and strips of a mesh as checked faces
 *
 * 1. Each cell is checked: its corners must lie within the connectivity, and each must name a
 *    point that exists. The check also finds the blocks (CellBlocks.h) of the faces.
 * 2. Where there are strips, the polygons and the strips' triangles become one list of faces
 *    (MergedFaces.h).
 * 3. The faces of cells with a point that is not finite are marked, so that they are ignored.
 *
 * All passes are parallel and have checkpoints.
 */
#ifndef lambent_CheckedFaces_h
#define lambent_CheckedFaces_h

#include "MergedFaces.h"
#include "PointNormals.h"

namespace lambent
{
/// The faces, and the memory that they need beyond the original spans. Cells count from 0,
/// first the polygons, then the strips.
struct CheckedFaces
{
  Faces faces;
  MergedFaces merged; ///< empty where there are no strips
  CellDefect defect;  ///< the first defect; if there is one, the faces are unusable

  std::size_t notFinite = 0; ///< the number of cells with a point that is not finite
  std::size_t firstNotFinite = 0;

  CheckedFaces() = default;
  CheckedFaces(CheckedFaces&&) = default; // the spans still point to the same memory
  CheckedFaces& operator=(CheckedFaces&&) = default;

  /// The cell that a face belongs to.
  std::int64_t cellOf(std::int64_t face) const
  {
    return this->merged.isEmpty() ? face : this->merged.cells[face];
  }
};

/// `merged` may be the result of mergeFaces() for the same polygons and strips; it is then reused.
CheckedFaces checkFaces(const TupleSpan& points, const CellSpan& polygons, const CellSpan& strips,
  const Parallel& parallel, MergedFaces merged = MergedFaces());
}

#endif
