// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cuts polygons and strips into triangles
 *
 * - A polygon without a concave corner becomes a fan from its first point.
 * - Any other polygon is cut by ear clipping in the plane of its Newell normal. The first convex
 *   corner whose triangle contains no other point is cut off, until three points are left or none
 *   is an ear. The remaining points become a fan.
 * - If triangles of that fan face the other way, by more than rounding, the outline touches or
 *   crosses itself. If it touches itself, it is cut again by the rules of TouchingPolygon.h. If it
 *   crosses itself, the first result stays.
 * - mergeFaces() has cut a strip already; only its bad points are looked for.
 *
 * A polygon of n points gives n - 2 triangles whatever its shape. So the place of each cell in the
 * list is known in advance, and cells can be cut in parallel. If a point of a cell is not finite or
 * does not exist, all corners of the cell's triangles are that point, or -1. Binning finds and
 * counts such cells (MeshDefects).
 *
 * G. H. Meisters, "Polygons Have Ears", American Mathematical Monthly 82(6), 1975.
 */
#ifndef lambent_Triangulation_h
#define lambent_Triangulation_h

#include "MergedFaces.h"
#include "Parallel.h"
#include "Spans.h"
#include "UnwrittenVector.h"

namespace lambent
{
struct TriangleList
{
  UnwrittenVector<std::int32_t> corners; ///< three per triangle
  UnwrittenVector<std::int64_t> cells;   ///< one per triangle
};

/// Cuts polygons, numbered from firstCell on. Their offsets must be valid, and there may be at most
/// 2^31 - 1 points.
TriangleList triangulate(const CellSpan& polygons, const TupleSpan& points, std::int64_t firstCell,
  const Parallel& parallel);

/// The same for a mesh with strips: its cells are numbered from firstCell on.
TriangleList triangulate(const MergedFaces& faces, const TupleSpan& points, std::int64_t firstCell,
  const Parallel& parallel);
}

#endif
