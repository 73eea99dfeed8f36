// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief polygons and strips as triangles
 *
 * - A polygon without a concave corner is a fan from its first point.
 * - Another one is cut by ear clipping in the plane of its Newell normal: of the
 *   corners that are convex and whose triangle holds no other point the first one
 *   is cut off, until three points are left, or none of those left is an ear; these
 *   become a fan.
 * - Where triangles of that fan are turned the other way, by more than rounding, the
 *   outline touches itself or crosses itself. If it touches itself, it is cut once more
 *   by the rules of TouchingPolygon.h; if it crosses itself, it stays as it was cut.
 * - A strip has been cut by mergeFaces() already; only its bad points are looked for.
 *
 * A polygon of n points gives n - 2 triangles whatever its shape, so that each
 * cell knows its place in the list and cells can be cut in parallel. A cell with a
 * wrong or non-finite point gives triangles of that point alone; they are found
 * and counted where triangles are streamed (MeshDefects).
 *
 * G. H. Meisters, "Polygons Have Ears", American Mathematical Monthly 82(6), 1975.
 */
#ifndef lambent_Triangulation_h
#define lambent_Triangulation_h

#include "MergedFaces.h"
#include "Parallel.h"
#include "Spans.h"

#include <vector>

namespace lambent
{
struct TriangleList
{
  std::vector<std::int32_t> corners; ///< three a triangle
  std::vector<std::int64_t> cells;   ///< one a triangle
};

/// The triangles of polygons, which are numbered from firstCell on. Their offsets must not be
/// broken; there may be at most 2^31 - 1 points.
TriangleList triangulate(const CellSpan& polygons, const TupleSpan& points, std::int64_t firstCell,
  const Parallel& parallel);

/// The same for a mesh with strips: its cells are numbered from firstCell on.
TriangleList triangulate(const MergedFaces& faces, const TupleSpan& points, std::int64_t firstCell,
  const Parallel& parallel);
}

#endif
