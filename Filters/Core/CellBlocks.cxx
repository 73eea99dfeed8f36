// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellBlocks.h"

#include "Chunks.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <type_traits>

namespace lambent
{
namespace
{
// Small enough to share out evenly and to name a narrow range of points, large
// enough that a block costs nothing beside its cells.
constexpr std::size_t CellsPerBlock = 1024;
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

bool isFinite(const Vec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

bool areFinite(const TupleSpan& points, const Parallel& parallel)
{
  std::atomic<bool> result{ true };
  forEachChunk(parallel, points.size, PointsPerChunk,
    [&](std::size_t begin, std::size_t end)
    {
      // Any infinity or NaN makes the sum of 0 * x a NaN; no branch for each point.
      double sum = 0.0;
      for (std::size_t i = begin; i < end; ++i)
      {
        const Vec3 p = points[i];
        sum += (0.0 * p.x + 0.0 * p.y) + 0.0 * p.z;
      }
      if (sum != 0.0)
      {
        result = false;
      }
    });
  return result;
}
}

std::vector<CellBlock> findBlocks(const CellSpan& cells, const Parallel& parallel)
{
  const std::size_t count = cellCount(cells);
  std::vector<CellBlock> blocks(chunkCount(count, CellsPerBlock));
  visit(cells,
    [&](auto view)
    {
      using Id = std::decay_t<decltype(*view.corners)>;
      forEachChunk(parallel, count, CellsPerBlock,
        [&](std::size_t begin, std::size_t end)
        {
          Id first = std::numeric_limits<Id>::max();
          Id last = std::numeric_limits<Id>::lowest();
          for (Id i = view.offsets[begin]; i < view.offsets[end]; ++i)
          {
            first = std::min(first, view.corners[i]);
            last = std::max(last, view.corners[i]);
          }
          const bool isEmpty = first > last;
          blocks[begin / CellsPerBlock] = { begin, end, isEmpty ? 0 : first, isEmpty ? -1 : last };
        });
    });
  return blocks;
}

CellDefect findDefect(const CellSpan& cells, std::size_t pointCount, const Parallel& parallel)
{
  const std::size_t count = cellCount(cells);
  std::vector<CellDefect> defects(chunkCount(count, CellsPerBlock));
  visit(cells,
    [&](auto view)
    {
      forEachChunk(parallel, count, CellsPerBlock,
        [&](std::size_t begin, std::size_t end)
        {
          CellDefect& defect = defects[begin / CellsPerBlock];
          for (std::size_t cell = begin; cell < end && !defect; ++cell)
          {
            defect = checkCell(view, cell, cells.connectivity.size, pointCount);
          }
        });
    });
  const auto first = std::find_if(
    defects.begin(), defects.end(), [](const CellDefect& d) { return static_cast<bool>(d); });
  return first == defects.end() ? CellDefect{} : *first;
}

std::vector<unsigned char> findNonFinite(
  const TupleSpan& points, const CellSpan& cells, const Parallel& parallel)
{
  std::vector<unsigned char> result;
  if (areFinite(points, parallel))
  {
    return result;
  }
  result.resize(cellCount(cells));
  visit(cells,
    [&](auto view)
    {
      for (std::size_t cell = 0; cell < cellCount(cells); ++cell)
      {
        const auto corners = view.cell(cell);
        result[cell] = !std::all_of(
          corners, corners + view.cellSize(cell), [&](auto id) { return isFinite(points[id]); });
      }
    });
  return result;
}
}
