// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief check cells, and summarize them in blocks
 *
 * One parallel pass over the cells. It finds cells with bad offsets or point ids, and
 * records what lets later passes process a block fast: whether it has only triangles,
 * and the range of the point ids that it names.
 */
#ifndef lambent_CellBlocks_h
#define lambent_CellBlocks_h

#include "CellView.h"
#include "Parallel.h"

#include <cstdint>
#include <vector>

namespace lambent
{
/// Cells begin to end - 1, with the smallest and largest point id that they name (0 and
/// -1 if they name none).
struct CellBlock
{
  std::size_t begin = 0, end = 0;
  std::int64_t firstPoint = 0, lastPoint = -1;
  bool hasOnlyTriangles = false;

  /// Whether the block may use a point in [begin, end).
  bool touches(std::int64_t beginPoint, std::int64_t endPoint) const
  {
    return this->firstPoint < endPoint && this->lastPoint >= beginPoint;
  }
};

/// An unusable cell: its offsets decrease or exceed the connectivity, or it uses a point that
/// does not exist.
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
  CellDefect defect; ///< of the first bad cell
  std::vector<CellBlock> blocks;
};

/// Checks cells whose point ids must lie in [0, pointCount).
CheckedCells checkCells(const CellSpan& cells, std::size_t pointCount, const Parallel& parallel);

/// One entry per cell, nonzero if any coordinate of its points is infinite or NaN. Empty if all
/// points are finite.
std::vector<unsigned char> findNonFinite(
  const TupleSpan& points, const CellSpan& cells, const Parallel& parallel);
}

#endif
