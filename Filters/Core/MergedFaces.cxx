// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MergedFaces.h"

namespace lambent
{
namespace
{
void closeFace(MergedFaces& faces, std::size_t cell)
{
  faces.offsets.push_back(static_cast<std::int64_t>(faces.connectivity.size()));
  faces.cells.push_back(static_cast<std::int64_t>(cell));
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

MergedFaces mergeFaces(const CellSpan& polygons, const CellSpan& strips)
{
  MergedFaces result;
  result.offsets.push_back(0);
  const std::size_t polygonCount = cellCount(polygons);
  visit(polygons,
    [&](auto cells)
    {
      for (std::size_t i = 0; i < polygonCount; ++i)
      {
        result.connectivity.insert(
          result.connectivity.end(), cells.cell(i), cells.cell(i) + cells.cellSize(i));
        closeFace(result, i);
      }
    });
  visit(strips,
    [&](auto cells)
    {
      for (std::size_t i = 0; i < cellCount(strips); ++i)
      {
        appendStrip(result, cells.cell(i), cells.cellSize(i), polygonCount + i);
      }
    });
  return result;
}
}
