// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellBlocks.h"

#include "CheckKernel.h"
#include "Chunks.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace lambent
{
namespace
{
// Small enough to balance the load and to name a narrow range of points, large
// enough that the cost of a block is negligible beside its cells.
constexpr std::size_t CellsPerBlock = 512;
constexpr std::size_t PointsPerChunk = 16384;

template <typename Id>
CellDefect checkCell(
  const CellView<Id>& cells, std::size_t cell, std::size_t cornerCount, std::size_t pointCount)
{
  const std::int64_t begin = cells.offsets[cell];
  const std::int64_t end = cells.offsets[cell + 1];
  if (begin < 0 || end < begin || end > static_cast<std::int64_t>(cornerCount))
  {
    return { CellDefect::Offsets, cell, 0 };
  }
  for (std::int64_t i = begin; i < end; ++i)
  {
    const std::int64_t point = cells.corners[i];
    if (point < 0 || point >= static_cast<std::int64_t>(pointCount))
    {
      return { CellDefect::Point, cell, point };
    }
  }
  return {};
}

template <typename Id>
CellDefect findDefect(const CellView<Id>& cells, const CellBlock& block, std::size_t cornerCount,
  std::size_t pointCount)
{
  CellDefect defect;
  for (std::size_t cell = block.begin; cell < block.end && !defect; ++cell)
  {
    defect = checkCell(cells, cell, cornerCount, pointCount);
  }
  return defect;
}

/// Fills in the block. Returns false if it has a defect.
template <typename Id>
bool summarize(
  const CellView<Id>& cells, std::size_t cornerCount, std::size_t pointCount, CellBlock& block)
{
  const OffsetKinds kinds = classifyOffsets(cells.offsets + block.begin, block.end - block.begin);
  const std::int64_t begin = cells.offsets[block.begin];
  const std::int64_t end = cells.offsets[block.end];
  if (!kinds.areAscending || begin < 0 || end > static_cast<std::int64_t>(cornerCount))
  {
    return false;
  }
  block.hasOnlyTriangles = kinds.areOfTriangles;
  if (begin == end)
  {
    return true;
  }
  const IdRange range = findRange(cells.corners + begin, static_cast<std::size_t>(end - begin));
  block.firstPoint = range.first;
  block.lastPoint = range.last;
  return range.first >= 0 && static_cast<std::size_t>(range.last) < pointCount;
}

bool arePointsFinite(const TupleSpan& points, const Parallel& parallel)
{
  std::atomic<bool> result{ true };
  forEachChunk<PointsPerChunk>(parallel, points.size,
    [&](std::size_t begin, std::size_t end)
    {
      const std::size_t first = 3 * begin;
      const std::size_t count = 3 * (end - begin);
      if (!(points.isDouble ? areFinite(static_cast<const double*>(points.data) + first, count)
                            : areFinite(static_cast<const float*>(points.data) + first, count)))
      {
        result = false;
      }
    });
  return result;
}
}

CheckedCells checkCells(const CellSpan& cells, std::size_t pointCount, const Parallel& parallel)
{
  const std::size_t count = cellCount(cells);
  CheckedCells result;
  result.blocks.resize(chunkCount(count, CellsPerBlock));
  std::vector<CellDefect> defects(result.blocks.size());
  visit(cells,
    [&](auto view)
    {
      forEachChunk<CellsPerBlock>(parallel, count,
        [&](std::size_t begin, std::size_t end)
        {
          CellBlock& block = result.blocks[begin / CellsPerBlock];
          block.begin = begin;
          block.end = end;
          if (!summarize(view, cells.connectivity.size, pointCount, block))
          {
            defects[begin / CellsPerBlock] =
              findDefect(view, block, cells.connectivity.size, pointCount);
          }
        });
    });
  const auto first = std::find_if(
    defects.begin(), defects.end(), [](const CellDefect& d) { return static_cast<bool>(d); });
  result.defect = first == defects.end() ? CellDefect{} : *first;
  return result;
}

std::vector<unsigned char> findNonFinite(
  const TupleSpan& points, const CellSpan& cells, const Parallel& parallel)
{
  std::vector<unsigned char> result;
  if (cellCount(cells) == 0 || arePointsFinite(points, parallel))
  {
    return result;
  }
  result.resize(cellCount(cells));
  visit(cells,
    [&](auto view)
    {
      forEachChunk<CellsPerBlock>(parallel, cellCount(cells),
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t cell = begin; cell < end; ++cell)
          {
            const auto corners = view.cell(cell);
            result[cell] = !std::all_of(corners, corners + view.cellSize(cell),
              [&](auto id) { return isFinite(points[id]); });
          }
        });
    });
  return result;
}
}
