// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckedFaces.h"

#include <algorithm>
#include <utility>

namespace lambent
{
namespace
{
/// Checks both lists. The blocks are those of the polygons.
void check(const TupleSpan& points, const CellSpan& polygons, const CellSpan& strips,
  const Parallel& parallel, CheckedFaces& result)
{
  CheckedCells ofPolygons = checkCells(polygons, points.size, Share(parallel, 0.0, 0.5));
  result.faces.points = points;
  result.faces.cells = polygons;
  result.faces.blocks = std::move(ofPolygons.blocks);
  result.defect = ofPolygons.defect;
  if (!result.defect)
  {
    result.defect = checkCells(strips, points.size, Share(parallel, 0.5, 1.0)).defect;
    result.defect.cell += cellCount(polygons);
  }
}

void markNotFinite(
  const CellSpan& polygons, const CellSpan& strips, const Parallel& parallel, CheckedFaces& result)
{
  Faces& faces = result.faces;
  std::vector<unsigned char> cells =
    findNonFinite(faces.points, polygons, Share(parallel, 0.0, 0.5));
  const std::vector<unsigned char> ofStrips =
    findNonFinite(faces.points, strips, Share(parallel, 0.5, 1.0));
  if (cells.empty() && ofStrips.empty())
  {
    return;
  }
  cells.resize(cellCount(polygons)); // empty if all are finite
  cells.insert(cells.end(), ofStrips.begin(), ofStrips.end());
  const auto first = std::find(cells.begin(), cells.end(), 1);
  if (first == cells.end())
  {
    return;
  }
  result.notFinite = static_cast<std::size_t>(std::count(first, cells.end(), 1));
  result.firstNotFinite = static_cast<std::size_t>(first - cells.begin());
  faces.skip.resize(cellCount(faces.cells));
  for (std::size_t face = 0; face < faces.skip.size(); ++face)
  {
    faces.skip[face] = cells[result.cellOf(static_cast<std::int64_t>(face))];
  }
}
}

CheckedFaces checkFaces(const TupleSpan& points, const CellSpan& polygons, const CellSpan& strips,
  const Parallel& parallel, MergedFaces merged)
{
  CheckedFaces result;
  check(points, polygons, strips, Share(parallel, 0.0, 0.4), result);
  if (result.defect)
  {
    return result;
  }
  if (cellCount(strips) > 0)
  {
    result.merged = merged.isEmpty() ? mergeFaces(polygons, strips, Share(parallel, 0.4, 0.6))
                                     : std::move(merged);
    result.faces.cells = result.merged.span();
    result.faces.blocks =
      checkCells(result.faces.cells, points.size, Share(parallel, 0.6, 0.7)).blocks;
  }
  markNotFinite(polygons, strips, Share(parallel, 0.7, 1.0), result);
  return result;
}
}
