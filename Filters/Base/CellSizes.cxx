// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellSizes.h"

#include "Chunks.h"

#include <hwy/cache_control.h>

namespace lambent
{
namespace
{
constexpr std::size_t cellsPerChunk = 4096;

/// Whether all cells [begin, end) are triangles, stored without gaps.
template <typename Offset>
bool areTriangles(const IndexSpan& offsets, std::size_t begin, std::size_t end)
{
  constexpr std::size_t line = 64 / sizeof(Offset), ahead = 64 * line;
  const auto* values = static_cast<const Offset*>(offsets.data);
  Offset different = 0;
  std::size_t cell = begin;
  for (; cell + line <= end; cell += line)
  {
    hwy::Prefetch(values + cell + ahead); // hardware prefetching does not keep up
    for (std::size_t k = cell; k < cell + line; ++k)
    {
      different |= values[k] ^ static_cast<Offset>(3 * k);
    }
  }
  for (; cell <= end; ++cell)
  {
    different |= values[cell] ^ static_cast<Offset>(3 * cell);
  }
  return different == 0;
}

/// Whether the offsets of the cells [begin, end) never decrease and stay within the connectivity.
bool areSound(const CellSpan& cells, std::size_t begin, std::size_t end)
{
  bool sound = true;
  for (std::size_t cell = begin; cell < end; ++cell)
  {
    const std::uint64_t from = cells.offsets[cell], to = cells.offsets[cell + 1];
    sound &= from <= to && to <= cells.connectivity.size;
  }
  return sound;
}
}

CellSizes inspect(const CellSpan& cells, const Parallel& parallel)
{
  const std::size_t count = cells.offsets.size > 0 ? cells.offsets.size - 1 : 0;
  std::atomic<bool> allTriangles{ true };
  std::atomic<bool> allSound{ count == 0 || cells.offsets[0] == 0 };
  forEachChunk<cellsPerChunk>(parallel, count,
    [&](std::size_t begin, std::size_t end)
    {
      const bool triangles = cells.offsets.is64Bit
        ? areTriangles<std::int64_t>(cells.offsets, begin, end)
        : areTriangles<std::int32_t>(cells.offsets, begin, end);
      if (triangles && 3 * end <= cells.connectivity.size)
      {
        return;
      }
      allTriangles = false;
      if (!areSound(cells, begin, end))
      {
        allSound = false;
      }
    });
  return allTriangles ? CellSizes::Triangles : allSound ? CellSizes::Mixed : CellSizes::Broken;
}
}
