// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cells in blocks, with the range of the points each block names
 *
 * One pass over the cells, in parallel. It finds cells that name points that do
 * not exist, and lets later passes that want only some of the points skip the
 * blocks that name none of them.
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
  std::size_t begin, end;
  std::int64_t firstPoint, lastPoint;

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

/// The blocks of a list whose cells are known to be sound.
std::vector<CellBlock> findBlocks(const CellSpan& cells, const Parallel& parallel);

/// The first defect in a list whose points are 0 to pointCount - 1.
CellDefect findDefect(const CellSpan& cells, std::size_t pointCount, const Parallel& parallel);

/// One entry per cell, not 0 where the cell has a point with a coordinate that is
/// infinite or not a number; empty if all points are finite.
std::vector<unsigned char> findNonFinite(
  const TupleSpan& points, const CellSpan& cells, const Parallel& parallel);
}

#endif
