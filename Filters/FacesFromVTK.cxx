// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FacesFromVTK.h"

#include "CellBlocks.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace lambent::adapters
{
namespace
{
TupleSpan pointsOf(vtkPolyData* polyData, SpansFromVTK& spans)
{
  vtkPoints* points = polyData->GetPoints();
  if (points && points->GetData()->GetNumberOfComponents() != 3)
  {
    std::ostringstream text;
    text << "The points have " << points->GetData()->GetNumberOfComponents()
         << " components, not 3. Give vtkPoints an array of 3.";
    throw std::runtime_error(text.str());
  }
  return spans.tuples(points ? points->GetData() : nullptr);
}

[[noreturn]] void refuse(const CellDefect& defect, vtkIdType cell, std::size_t points)
{
  std::ostringstream text;
  if (defect.kind == CellDefect::Offsets)
  {
    text << "Cell " << cell
         << " begins or ends outside of the connectivity of its vtkCellArray. Rebuild the "
            "array, for instance with InsertNextCell().";
  }
  else
  {
    text << "Cell " << cell << " names point " << defect.point << ", but there are ";
    if (points > 0)
    {
      text << points << " points, 0 to " << points - 1;
    }
    else
    {
      text << "no points";
    }
    text << ". Correct the connectivity of its vtkCellArray, or add the missing points.";
  }
  throw std::runtime_error(text.str());
}
}

FacesFromVTK::FacesFromVTK(vtkPolyData* polyData, const Parallel& parallel)
{
  this->Mesh.points = pointsOf(polyData, this->Spans);
  vtkCellArray* const arrays[] = { polyData->GetVerts(), polyData->GetLines(), polyData->GetPolys(),
    polyData->GetStrips() };
  CellSpan lists[4];
  CheckedCells checked[4];
  vtkIdType firstCell = 0;
  for (int i = 0; i < 4; ++i)
  {
    lists[i] = this->Spans.cells(arrays[i]);
    checked[i] =
      checkCells(lists[i], this->Mesh.points.size, Share(parallel, 0.1 * i, 0.1 * (i + 1)));
    if (const CellDefect& defect = checked[i].defect)
    {
      refuse(defect, firstCell + static_cast<vtkIdType>(defect.cell), this->Mesh.points.size);
    }
    firstCell += static_cast<vtkIdType>(cellCount(lists[i]));
  }

  const CellSpan& polygons = lists[2];
  const CellSpan& strips = lists[3];
  this->Mesh.cells = polygons;
  this->Mesh.blocks = std::move(checked[2].blocks);
  if (cellCount(strips) > 0)
  {
    this->Merged = mergeFaces(polygons, strips, Share(parallel, 0.4, 0.6));
    this->setCells(this->Merged.span(), Share(parallel, 0.6, 0.7));
  }
  this->markNonFinite(polygons, strips, polyData->GetNumberOfVerts() + polyData->GetNumberOfLines(),
    Share(parallel, 0.7, 1.0));
}

void FacesFromVTK::markNonFinite(const CellSpan& polygons, const CellSpan& strips,
  vtkIdType firstPolygon, const Parallel& parallel)
{
  std::vector<unsigned char> cells =
    findNonFinite(this->Mesh.points, polygons, Share(parallel, 0.0, 0.5));
  const std::vector<unsigned char> ofStrips =
    findNonFinite(this->Mesh.points, strips, Share(parallel, 0.5, 1.0));
  cells.insert(cells.end(), ofStrips.begin(), ofStrips.end());
  const auto first = std::find(cells.begin(), cells.end(), 1);
  if (first == cells.end())
  {
    return;
  }
  std::ostringstream text;
  text << std::count(first, cells.end(), 1)
       << " cells have points with coordinates that are infinite or not numbers, and count for "
          "nothing; the first is cell "
       << firstPolygon + (first - cells.begin()) << ". Correct or remove them.";
  this->Warning = text.str();

  this->Mesh.skip.resize(cellCount(this->Mesh.cells));
  for (std::size_t face = 0; face < this->Mesh.skip.size(); ++face)
  {
    this->Mesh.skip[face] = cells[this->cellOf(static_cast<std::int64_t>(face))];
  }
}

void FacesFromVTK::setCells(const CellSpan& cells, const Parallel& parallel)
{
  this->Mesh.cells = cells;
  this->Mesh.blocks = checkCells(cells, this->Mesh.points.size, parallel).blocks;
}

void FacesFromVTK::refer(vtkPolyData* rewritten, const Parallel& parallel)
{
  this->Mesh.points = pointsOf(rewritten, this->Spans);
  this->setCells(this->Spans.cells(rewritten->GetPolys()), parallel);
}
}
