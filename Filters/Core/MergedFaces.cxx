// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MergedFaces.h"

#include "Chunks.h"

#include <algorithm>

namespace lambent
{
namespace
{
void closeFace(MergedFaces& faces, std::size_t cell)
{
  faces.offsets.push_back(static_cast<std::int64_t>(faces.connectivity.size()));
  faces.cells.push_back(static_cast<std::int64_t>(cell));
}

std::size_t triangleCount(const CellSpan& strips)
{
  std::size_t count = 0;
  visit(strips,
    [&](auto cells)
    {
      for (std::size_t i = 0; i < cellCount(strips); ++i)
      {
        count += std::max<std::size_t>(cells.cellSize(i), 2) - 2;
      }
    });
  return count;
}

template <typename Id>
void appendStrip(MergedFaces& faces, const Id* points, std::size_t size, std::size_t cell)
{
  for (std::size_t i = 0; i + 2 < size; ++i)
  {
    const std::size_t odd = i % 2;
    faces.connectivity.insert(
      faces.connectivity.end(), { points[i + odd], points[i + 1 - odd], points[i + 2] });
    closeFace(faces, cell);
  }
}
}

MergedFaces mergeFaces(const CellSpan& polygons, const CellSpan& strips, const Parallel& parallel)
{
  const std::size_t polygonCount = cellCount(polygons);
  const std::size_t triangles = triangleCount(strips);
  MergedFaces result;
  result.connectivity.reserve(polygons.connectivity.size + 3 * triangles);
  result.offsets.reserve(polygonCount + triangles + 1);
  result.cells.reserve(polygonCount + triangles);
  result.offsets.push_back(0);
  visit(polygons,
    [&](auto cells)
    {
      forEachPart(Share(parallel, 0.0, 0.5), polygonCount,
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t i = begin; i < end; ++i)
          {
            result.connectivity.insert(
              result.connectivity.end(), cells.cell(i), cells.cell(i) + cells.cellSize(i));
            closeFace(result, i);
          }
        });
    });
  visit(strips,
    [&](auto cells)
    {
      const Share share(parallel, 0.5, 1.0);
      PartClock clock;
      for (std::size_t i = 0; i < cellCount(strips); ++i)
      {
        appendStrip(result, cells.cell(i), cells.cellSize(i), polygonCount + i);
        if (clock.isOver())
        {
          share.checkpoint(static_cast<double>(i + 1) / static_cast<double>(cellCount(strips)));
          clock = PartClock();
        }
      }
    });
  return result;
}
}
