// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFromVTK.h"

#include "CellEdgeFlags.h"
#include "CellSizes.h"
#include "CheckedFaces.h"
#include "Chunks.h"
#include "GhostsFromVTK.h"
#include "MissingPoint.h"
#include "PassArrays.h"
#include "SpheresFromVTK.h"
#include "TriangleNormals.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

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

SurfaceFromVTK::SurfaceFromVTK(const SceneSettings::Input& input, const Appearance& appearance,
  const LineStyle& lineStyle, const Parallel& parallel)
  : Input(input.mesh)
  , Placement(input.transform)
  , PlacementOfNormals(input.transform)
{
  const double pointsShare = input.transform.isIdentity() ? 0.0 : 0.2;
  const bool hasFaces = lineStyle.representation == LineStyle::Surface;
  const double linesShare = hasFaces ? pointsShare : 1.0, trianglesShare = 0.9;
  this->Result.appearance = appearance;
  this->setPoints(Share(parallel, 0.0, pointsShare));
  if (input.spheres.areOn())
  {
    setSpheres(input.spheres, input.mesh, this->Spans, this->Result);
    return;
  }
  this->Lines = std::make_unique<LinesFromVTK>(input.mesh, this->Result.points, appearance,
    lineStyle, this->Spans, Share(parallel, pointsShare, linesShare));
  if (!hasFaces)
  {
    return;
  }
  this->setCells(Share(parallel, linesShare, trianglesShare));
  this->chooseTriangles(Share(parallel, trianglesShare, 1.0));
  vtkDataArray* cellNormals = input.mesh->GetCellData()->GetNormals();
  if (cellNormals && appearance.shading == Shading::Flat)
  {
    this->Result.cellNormals =
      this->normals(cellNormals, input.mesh->GetNumberOfCells(), "cell", Share(parallel, 1.0, 1.0));
  }
}

void SurfaceFromVTK::setPointNormals(vtkDataArray* normals, const Parallel& parallel)
{
  this->PointNormals = this->normals(normals, this->Input->GetNumberOfPoints(), "point", parallel);
  this->Result.pointNormals = this->PointNormals;
}

const std::vector<std::unique_ptr<Surface>>& SurfaceFromVTK::lines() const
{
  static const std::vector<std::unique_ptr<Surface>> none;
  return this->Lines ? this->Lines->surfaces() : none;
}

void SurfaceFromVTK::append(std::vector<Surface>& to) const
{
  if (this->Lines)
  {
    this->Lines->append(this->Result, this->PointNormals, to);
  }
  to.push_back(this->Result);
}

void SurfaceFromVTK::computeNormals(double featureAngle, const Parallel& parallel)
{
  CheckedFaces checked = checkFaces(this->Result.points, this->Polygons, this->Strips,
    Share(parallel, 0.0, 0.2), std::move(this->Merged));
  if (checked.defect)
  {
    throw std::runtime_error(this->describeWrongCell(
      this->firstPolygon() + static_cast<std::int64_t>(checked.defect.cell)));
  }
  skipUnused(this->Uses, checked);
  this->Normals = computeCornerNormals(checked.faces, featureAngle, Share(parallel, 0.2, 0.95));
  if (this->PlacementOfNormals.isMirror())
  {
    float* const values = this->Normals.normals.get();
    std::transform(values, values + 3 * this->Normals.count, values, std::negate<>());
  }
  this->Result.pointNormals = { this->Normals.normals.get(), false, this->Normals.count };
  if (this->Normals.numbers)
  {
    this->setNormalNumbers(checked.faces.cells, Share(parallel, 0.95, 1.0));
  }
}

void SurfaceFromVTK::setNormalNumbers(const CellSpan& faces, const Parallel& parallel)
{
  IndexSpan numbers{ this->Normals.numbers.get(), false, this->AllCorners.size };
  if (!this->Triangles.corners.empty())
  {
    this->NormalNumbers = numbersOfTriangles(faces, this->Normals, this->AllCorners, parallel);
    numbers.data = this->NormalNumbers.data();
  }
  if (!this->Drawn.areUnchanged())
  {
    this->DrawnNumbers = this->Drawn.pick(numbers, parallel);
    numbers = this->DrawnNumbers.span();
  }
  this->Result.normalNumbers = numbers;
}

void SurfaceFromVTK::addColors(const InputColors& settings)
{
  if (settings.scalarVisibility)
  {
    this->Colors = std::make_unique<ColorsFromVTK>(this->Input, settings, this->Spans);
    this->Result.colors = this->Colors->colors();
    if (this->Result.colors && this->Result.kind() == PrimitiveKind::Sphere &&
      this->Result.colors->values.isPerCell)
    {
      throw std::runtime_error(
        "the colours come from a cell array, but spheres have the colours of "
        "points. Call SetInputColorArray() with a point array.");
    }
  }
}

void SurfaceFromVTK::addTexture(const Texture& texture)
{
  vtkDataArray* const coordinates = this->Input->GetPointData()->GetTCoords();
  const vtkIdType expected = this->Input->GetNumberOfPoints();
  const int components = coordinates->GetNumberOfComponents();
  if (coordinates->GetNumberOfTuples() != expected || components < 1 || components > 3)
  {
    std::ostringstream text;
    text << "the texture coordinates, point array " << describe(coordinates) << ", have "
         << coordinates->GetNumberOfTuples() << " tuples of " << components
         << " components, but there are " << expected
         << " points, each of which needs a tuple of 1 to 3. Compute them again, for instance with "
            "vtkTextureMapToPlane, or call SetInputTexture() with nullptr.";
    throw std::runtime_error(text.str());
  }
  this->Textured = std::make_unique<const TextureMap>(
    TextureMap{ texture, this->Spans.attribute(coordinates, false) });
  this->Result.texture = this->Textured.get();
}

void SurfaceFromVTK::addAttribute(const SceneSettings::PassArray& wanted)
{
  vtkDataArray* const array = findArray(this->Input, wanted);
  const bool isPerCell = wanted.association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  const vtkIdType expected =
    isPerCell ? this->Input->GetNumberOfCells() : this->Input->GetNumberOfPoints();
  if (array && (array->GetNumberOfTuples() != expected || array->GetNumberOfComponents() < 1))
  {
    std::ostringstream text;
    text << "the " << adapters::describe(wanted) << " has " << array->GetNumberOfTuples()
         << " tuples of " << array->GetNumberOfComponents() << " components, but there are "
         << expected << (isPerCell ? " cells" : " points")
         << ", each of which needs a tuple. Correct the array, or call RemoveAllPassArrays().";
    throw std::runtime_error(text.str());
  }
  this->Result.attributes.push_back(this->Spans.attribute(array, isPerCell));
}

TupleSpan SurfaceFromVTK::normals(
  vtkDataArray* normals, vtkIdType expected, const char* kind, const Parallel& parallel)
{
  if (normals->GetNumberOfComponents() != 3 || normals->GetNumberOfTuples() != expected)
  {
    std::ostringstream text;
    text << "the " << kind << " normals, array " << describe(normals) << ", have "
         << normals->GetNumberOfTuples() << " tuples of " << normals->GetNumberOfComponents()
         << " components, but there are " << expected << " " << kind
         << "s, each of which needs a tuple of 3. Remove the array or compute it again, for "
            "instance with vtkLambentNormals.";
    throw std::runtime_error(text.str());
  }
  const TupleSpan given = this->Spans.tuples(normals);
  if (this->Placement.isIdentity() || !given)
  {
    return given;
  }
  this->GivenNormals.resize(3 * given.size);
  transformNormals(this->PlacementOfNormals, given, parallel, this->GivenNormals.data());
  return { this->GivenNormals.data(), true, given.size };
}

void SurfaceFromVTK::setPoints(const Parallel& parallel)
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
  if (!this->Placement.isIdentity())
  {
    this->Points.resize(3 * this->Result.points.size);
    transformPoints(this->Placement, this->Result.points, parallel, this->Points.data());
    this->Result.points = { this->Points.data(), true, this->Result.points.size };
  }
}

void SurfaceFromVTK::setCells(const Parallel& parallel)
{
  this->Polygons = this->Spans.cells(this->Input->GetPolys());
  this->Strips = this->Spans.cells(this->Input->GetStrips());
  const CellSizes sizes = inspect(this->Polygons, Share(parallel, 0.0, 0.1));
  if (sizes == CellSizes::Broken ||
    inspect(this->Strips, Share(parallel, 0.1, 0.2)) == CellSizes::Broken)
  {
    throw std::runtime_error(std::string("the offsets of the ") +
      (sizes == CellSizes::Broken ? "polygons" : "strips") +
      " decrease or reach beyond their connectivity. Rebuild the vtkCellArray, for instance "
      "with InsertNextCell().");
  }
  const bool hasStrips = cellCount(this->Strips) > 0;
  if (sizes == CellSizes::Triangles && !hasStrips)
  {
    this->Result.corners = this->Polygons.connectivity;
    this->Result.corners.size = 3 * cellCount(this->Polygons);
    this->Result.firstCell = this->firstPolygon();
    return;
  }
  if (this->Input->GetNumberOfPoints() > std::numeric_limits<std::int32_t>::max())
  {
    throw std::runtime_error("polygons and strips of more than 2147483647 points cannot be "
                             "triangulated here. Run vtkTriangleFilter first.");
  }
  if (hasStrips)
  {
    this->Merged = mergeFaces(this->Polygons, this->Strips, Share(parallel, 0.2, 0.4));
  }
  const bool hasEdges = this->Result.appearance.edges.areVisible;
  const Share rest(parallel, 0.4, hasEdges ? 0.9 : 1.0);
  this->Triangles = hasStrips
    ? triangulate(this->Merged, this->Result.points, this->firstPolygon(), rest)
    : triangulate(this->Polygons, this->Result.points, this->firstPolygon(), rest);
  this->Result.corners = { this->Triangles.corners.data(), false, this->Triangles.corners.size() };
  this->Result.cells = this->Triangles.cells.data();
  if (hasEdges)
  {
    this->CellEdges = findCellEdges(
      hasStrips ? this->Merged.span() : this->Polygons, this->Triangles, Share(parallel, 0.9, 1.0));
    this->Result.cellEdges = this->CellEdges.data();
  }
}

void SurfaceFromVTK::chooseTriangles(const Parallel& parallel)
{
  this->AllCorners = this->Result.corners;
  const GhostFlags ghosts = ghostsFromVTK(this->Input);
  this->Uses = findCellUses(
    this->Polygons, this->Strips, this->Result.points.size, ghosts, Share(parallel, 0.0, 0.4));
  this->Drawn = DrawnTriangles(this->AllCorners.size / 3, this->Result.cells, this->firstPolygon(),
    this->Uses, this->PlacementOfNormals.isMirror(), Share(parallel, 0.4, 0.7));
  if (this->Drawn.areUnchanged())
  {
    return;
  }
  this->DrawnCorners = this->Drawn.pick(this->AllCorners, Share(parallel, 0.7, 1.0));
  this->Result.corners = this->DrawnCorners.span();
  if (!this->Uses.empty())
  {
    this->Result.cells = this->Drawn.cells().data();
  }
  if (this->Result.cellEdges)
  {
    this->CellEdges = this->Drawn.pickEdges(this->CellEdges, Share(parallel, 1.0, 1.0));
    this->Result.cellEdges = this->CellEdges.data();
  }
}

std::int64_t SurfaceFromVTK::firstPolygon() const
{
  return this->Input->GetNumberOfVerts() + this->Input->GetNumberOfLines();
}

std::string SurfaceFromVTK::describeWrongCell(std::int64_t cell) const
{
  const auto place = static_cast<std::size_t>(cell - this->firstPolygon());
  const std::size_t polygons = cellCount(this->Polygons);
  const CellSpan& cells = place < polygons ? this->Polygons : this->Strips;
  const std::size_t k = place < polygons ? place : place - polygons;
  for (std::size_t corner = cells.offsets[k]; corner < cells.offsets[k + 1]; ++corner)
  {
    const std::uint64_t point = cells.connectivity[corner];
    if (point >= this->Result.points.size)
    {
      return "cell " + std::to_string(cell) + " " +
        describeMissingPoint(
          static_cast<vtkIdType>(point), static_cast<vtkIdType>(this->Result.points.size));
    }
  }
  return "";
}
}
