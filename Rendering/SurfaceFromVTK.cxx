// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFromVTK.h"

#include "CellSizes.h"
#include "Chunks.h"
#include "FacesFromVTK.h"
#include "TriangleNormals.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <limits>
#include <sstream>
#include <stdexcept>

namespace lambent::adapters
{
namespace
{
std::string describe(vtkDataArray* array)
{
  const char* name = array->GetName();
  return name && *name ? "\"" + std::string(name) + "\"" : "without a name";
}
}

SurfaceFromVTK::SurfaceFromVTK(
  vtkPolyData* polyData, const Appearance& appearance, const Parallel& parallel)
  : Input(polyData)
{
  this->Result.appearance = appearance;
  this->setPoints();
  this->setCells(parallel);
  vtkDataArray* cellNormals = polyData->GetCellData()->GetNormals();
  if (cellNormals && appearance.shading == Shading::Flat)
  {
    this->Result.cellNormals = this->normals(cellNormals, polyData->GetNumberOfCells(), "cell");
  }
}

void SurfaceFromVTK::setPointNormals(vtkDataArray* normals)
{
  this->Result.pointNormals = this->normals(normals, this->Input->GetNumberOfPoints(), "point");
}

void SurfaceFromVTK::computeNormals(double featureAngle, const Parallel& parallel)
{
  const FacesFromVTK mesh(this->Input, Share(parallel, 0.0, 0.2));
  this->Normals = computeCornerNormals(mesh.faces(), featureAngle, Share(parallel, 0.2, 0.95));
  this->Result.pointNormals = { this->Normals.normals.get(), false, this->Normals.count };
  if (!this->Normals.numbers)
  {
    return;
  }
  const IndexSpan& corners = this->Result.corners;
  this->Result.normalNumbers = { this->Normals.numbers.get(), false, corners.size };
  if (!this->Triangles.corners.empty())
  {
    this->NormalNumbers =
      numbersOfTriangles(mesh.faces().cells, this->Normals, corners, Share(parallel, 0.95, 1.0));
    this->Result.normalNumbers.data = this->NormalNumbers.data();
  }
}

TupleSpan SurfaceFromVTK::normals(vtkDataArray* normals, vtkIdType expected, const char* kind)
{
  if (normals->GetNumberOfComponents() != 3 || normals->GetNumberOfTuples() != expected)
  {
    std::ostringstream text;
    text << "the " << kind << " normals, array " << describe(normals) << ", have "
         << normals->GetNumberOfTuples() << " tuples of " << normals->GetNumberOfComponents()
         << " components, but there are " << expected << " " << kind
         << "s, each of which needs a tuple of 3. Remove the array or compute it anew, for "
            "instance with vtkLambentNormals.";
    throw std::runtime_error(text.str());
  }
  return this->Spans.tuples(normals);
}

void SurfaceFromVTK::setPoints()
{
  vtkPoints* points = this->Input->GetPoints();
  if (!points || points->GetNumberOfPoints() == 0)
  {
    return;
  }
  if (points->GetData()->GetNumberOfComponents() != 3)
  {
    throw std::runtime_error("the points have " +
      std::to_string(points->GetData()->GetNumberOfComponents()) + " components, not 3.");
  }
  this->Result.points = this->Spans.tuples(points->GetData());
}

void SurfaceFromVTK::setCells(const Parallel& parallel)
{
  vtkPolyData* input = this->Input;
  const vtkIdType firstPolygon = input->GetNumberOfVerts() + input->GetNumberOfLines();
  const vtkIdType firstStrip = firstPolygon + input->GetNumberOfPolys();
  const CellSpan polygons = this->Spans.cells(input->GetPolys());
  const CellSpan strips = this->Spans.cells(input->GetStrips());
  const CellSizes sizes = inspect(polygons, parallel);
  if (sizes == CellSizes::Broken || inspect(strips, parallel) == CellSizes::Broken)
  {
    throw std::runtime_error(std::string("the offsets of the ") +
      (sizes == CellSizes::Broken ? "polygons" : "strips") +
      " decrease or reach beyond their connectivity. Rebuild the vtkCellArray, for instance "
      "with InsertNextCell().");
  }
  if (sizes == CellSizes::Triangles && input->GetNumberOfStrips() == 0)
  {
    this->Result.corners = polygons.connectivity;
    this->Result.corners.size = 3 * static_cast<std::size_t>(input->GetNumberOfPolys());
    this->Result.firstCell = firstPolygon;
    return;
  }
  if (input->GetNumberOfPoints() > std::numeric_limits<std::int32_t>::max())
  {
    throw std::runtime_error("polygons and strips of more than 2147483647 points cannot be cut "
                             "into triangles here. Run vtkTriangleFilter first.");
  }
  triangulate(
    polygons, CellKind::Polygons, this->Result.points, firstPolygon, parallel, this->Triangles);
  triangulate(strips, CellKind::Strips, this->Result.points, firstStrip, parallel, this->Triangles);
  this->Result.corners = { this->Triangles.corners.data(), false, this->Triangles.corners.size() };
  this->Result.cells = this->Triangles.cells.data();
}

std::string SurfaceFromVTK::describeWrongCell(std::int64_t cell) const
{
  const vtkIdType firstPolygon = this->Input->GetNumberOfVerts() + this->Input->GetNumberOfLines();
  const vtkIdType firstStrip = firstPolygon + this->Input->GetNumberOfPolys();
  vtkNew<vtkIdList> ids;
  if (cell < firstStrip)
  {
    this->Input->GetPolys()->GetCellAtId(cell - firstPolygon, ids);
  }
  else
  {
    this->Input->GetStrips()->GetCellAtId(cell - firstStrip, ids);
  }
  const vtkIdType points = this->Input->GetNumberOfPoints();
  std::ostringstream text;
  for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
  {
    const vtkIdType id = ids->GetId(k);
    if (id < 0 || id >= points)
    {
      text << "cell " << cell << " names point " << id << ", but there are ";
      if (points > 0)
      {
        text << points << " points, 0 to " << points - 1;
      }
      else
      {
        text << "no points";
      }
      text << ". Correct the connectivity of its vtkCellArray, or add the missing points.";
      break;
    }
  }
  return text.str();
}
}
