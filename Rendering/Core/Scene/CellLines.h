// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the lines and points that show cells: polylines, vertices, edges, corners
 *
 * Each function appends to a list, in the order of the cells. Cells whose use is not Drawn are left
 * out. Offsets must not be broken, and all points must exist.
 */
#ifndef lambent_CellLines_h
#define lambent_CellLines_h

#include "DrawnTriangles.h"
#include "Spans.h"

#include <cstdint>
#include <vector>

namespace lambent
{
/// Line k has its ends at the points corners[2k] and corners[2k + 1], and belongs to cells[k]. A
/// point is a line with both ends at one point.
struct LineList
{
  std::vector<std::int64_t> corners;
  std::vector<std::int64_t> cells;

  void add(std::uint64_t a, std::uint64_t b, std::int64_t cell)
  {
    this->corners.push_back(static_cast<std::int64_t>(a));
    this->corners.push_back(static_cast<std::int64_t>(b));
    this->cells.push_back(cell);
  }
};

/// Some cells, and the number and the use of the first. `uses` is nullptr if all are drawn.
struct CellGroup
{
  CellSpan cells;
  std::int64_t firstCell = 0;
  const CellUse* uses = nullptr;

  bool isDrawn(std::size_t cell) const { return !this->uses || this->uses[cell] == CellUse::Drawn; }
};

/// Adds the points of vertices.
void addVertices(const CellGroup& vertices, LineList& list);

/// Adds the segments of polylines.
void addPolylines(const CellGroup& polylines, LineList& list);

/// Adds the edges of polygons, and of the triangles of strips. An edge that several cells share is
/// added once, for the first of them.
void addEdges(
  const CellGroup& polygons, const CellGroup& strips, std::size_t pointCount, LineList& list);

/// Adds each point that is used once, for the first cell that uses it.
void addUsedPoints(const std::vector<CellGroup>& groups, std::size_t pointCount, LineList& list);
}

#endif
