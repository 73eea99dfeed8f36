// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FacesFromVTK.h"

#include "MissingPoint.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <sstream>
#include <stdexcept>

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
         << " components, not 3. Give vtkPoints an array of 3 components.";
    throw std::runtime_error(text.str());
  }
  return spans.tuples(points ? points->GetData() : nullptr);
}

[[noreturn]] void refuse(const CellDefect& defect, vtkIdType cell, std::size_t points)
{
  std::ostringstream text;
  text << "Cell " << cell << " ";
  if (defect.kind == CellDefect::Offsets)
  {
    text << "begins or ends outside the connectivity of its vtkCellArray. Rebuild the "
            "array, for instance with InsertNextCell().";
  }
  else
  {
    text << describeMissingPoint(defect.point, static_cast<vtkIdType>(points));
  }
  throw std::runtime_error(text.str());
}

/// Checks vertices or lines. The filter does not use them, but downstream filters follow their
/// point ids. Returns how many there are.
vtkIdType checkOthers(
  const CellSpan& cells, vtkIdType firstCell, std::size_t points, const Parallel& parallel)
{
  const CellDefect defect = checkCells(cells, points, parallel).defect;
  if (defect)
  {
    refuse(defect, firstCell + static_cast<vtkIdType>(defect.cell), points);
  }
  return static_cast<vtkIdType>(cellCount(cells));
}
}

FacesFromVTK::FacesFromVTK(vtkPolyData* polyData, const Parallel& parallel)
{
  const TupleSpan points = pointsOf(polyData, this->Spans);
  vtkIdType firstPolygon =
    checkOthers(this->Spans.cells(polyData->GetVerts()), 0, points.size, Share(parallel, 0.0, 0.1));
  firstPolygon += checkOthers(
    this->Spans.cells(polyData->GetLines()), firstPolygon, points.size, Share(parallel, 0.1, 0.2));
  this->Checked = checkFaces(points, this->Spans.cells(polyData->GetPolys()),
    this->Spans.cells(polyData->GetStrips()), Share(parallel, 0.2, 1.0));
  if (const CellDefect& defect = this->Checked.defect)
  {
    refuse(defect, firstPolygon + static_cast<vtkIdType>(defect.cell), points.size);
  }
  if (this->Checked.notFinite > 0)
  {
    std::ostringstream text;
    text << this->Checked.notFinite
         << " cells have points with coordinates that are infinite or NaN, and are ignored; the "
            "first is cell "
         << firstPolygon + static_cast<vtkIdType>(this->Checked.firstNotFinite)
         << ". Correct or remove them.";
    this->Warning = text.str();
  }
}

void FacesFromVTK::refer(vtkPolyData* rewritten, const Parallel& parallel)
{
  Faces& faces = this->Checked.faces;
  faces.points = pointsOf(rewritten, this->Spans);
  faces.cells = this->Spans.cells(rewritten->GetPolys());
  faces.blocks = checkCells(faces.cells, faces.points.size, parallel).blocks;
}
}
