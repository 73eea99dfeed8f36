// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cells in blocks, checked, with the range of the points each block names
 *
 * One pass over the cells, in parallel. It finds cells that name points that do
 * not exist, and what lets later passes go through a block fast: whether it has
 * only triangles, and between which points lie all that it names.
 */
#ifndef lambent_CellBlocks_h
#define lambent_CellBlocks_h

#include "CellView.h"
#include "Parallel.h"

#include <cstdint>
#include <vector>

namespace lambent
{
/// Cells begin to end - 1, and the smallest and largest point that they name (0 and
/// -1 if they name none).
struct CellBlock
{
  std::size_t begin = 0, end = 0;
  std::int64_t firstPoint = 0, lastPoint = -1;
  bool hasOnlyTriangles = false;

  /// True where the block may name a point in [begin, end).
  bool touches(std::int64_t beginPoint, std::int64_t endPoint) const
  {
    return this->firstPoint < endPoint && this->lastPoint >= beginPoint;
  }
};

/// A cell that cannot be used: its offsets run backwards or beyond the corners, or
/// it names a point that does not exist.
struct CellDefect
{
  enum Kind
  {
    None,
    Offsets,
    Point
  };
  Kind kind = None;
  std::size_t cell = 0;
  std::int64_t point = 0;

  explicit operator bool() const { return this->kind != None; }
};

struct CheckedCells
{
  CellDefect defect; ///< the first one
  std::vector<CellBlock> blocks;
};

/// Checks a list whose points are 0 to pointCount - 1.
CheckedCells checkCells(const CellSpan& cells, std::size_t pointCount, const Parallel& parallel);

/// One entry per cell, not 0 where the cell has a point with a coordinate that is
/// infinite or not a number; empty if all points are finite.
std::vector<unsigned char> findNonFinite(
  const TupleSpan& points, const CellSpan& cells, const Parallel& parallel);
}

#endif
