// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BodySurface.h"

#include "CellSizes.h"
#include "CellView.h"
#include "TriangleNormals.h"

#include <stdexcept>

namespace
{
constexpr double featureAngle = 30.0; // the ray tracer's default
}

BodySurface::BodySurface(const Body& body, const lambent::Parallel& parallel)
  : HasFloats(body.hasFloatPoints)
  , HasNarrowIds(body.has32BitIds)
  , HasStrips(body.hasStrips)
{
  this->setPoints(body);
  body.hasSpheres() ? this->setSpheres(body) : this->setCells(body, parallel);
  this->Result.pointNormals = keep(body.pointNormals, this->PointNormals);
  if (body.appearance.shading == lambent::Shading::Flat)
  {
    this->Result.cellNormals = keep(body.cellNormals, this->CellNormals);
  }
  this->Result.appearance = body.appearance;
  if (!body.colors.array.empty())
  {
    this->setColors(body);
  }
}

void BodySurface::setColors(const Body& body)
{
  this->ColorSettings = body.colors; // keeps the entries
  const StageColors& colors = this->ColorSettings;
  for (const StageArray& array : body.arrays)
  {
    if (array.name == colors.array && array.isPerCell == colors.isPerCell)
    {
      this->ColorValues = array.memory();
      this->Colors.values = { this->ColorValues.data(), array.type, array.components,
        array.isPerCell };
    }
  }
  this->Colors.component = colors.component;
  this->Colors.isMappedLast = colors.isMappedLast;
  if (!colors.entries.empty())
  {
    this->Table = std::make_unique<lambent::ColorTable>(
      colors.entries.data(), colors.entryCount(), colors.low, colors.high, colors.isLogarithmic);
    if (colors.hasSpecialColors)
    {
      this->Table->setNotANumber(colors.special(0));
      this->Table->setBelow(colors.special(1));
      this->Table->setAbove(colors.special(2));
    }
    this->Colors.table = this->Table.get();
  }
  this->Result.colors = &this->Colors;
}

void BodySurface::setPoints(const Body& body)
{
  for (const Vec3& p : body.shape.points)
  {
    this->Doubles.insert(this->Doubles.end(), { p.x, p.y, p.z });
  }
  this->Floats.assign(this->Doubles.begin(), this->Doubles.end());
  this->Result.points = this->points();
}

// As for polydata: a list of triangles is used in place, all other cells are triangulated.
void BodySurface::setCells(const Body& body, const lambent::Parallel& parallel)
{
  this->Offsets64.push_back(0);
  for (const auto& cell : body.shape.cells)
  {
    this->Ids64.insert(this->Ids64.end(), cell.begin(), cell.end());
    this->Offsets64.push_back(static_cast<std::int64_t>(this->Ids64.size()));
  }
  this->Ids32.assign(this->Ids64.begin(), this->Ids64.end());
  this->Offsets32.assign(this->Offsets64.begin(), this->Offsets64.end());
  if (!this->HasStrips && inspect(this->cells(), parallel) == lambent::CellSizes::Triangles)
  {
    this->Result.corners = this->cells().connectivity;
    return;
  }
  this->Triangles = this->HasStrips
    ? triangulate(
        mergeFaces(lambent::CellSpan(), this->cells(), parallel), this->points(), 0, parallel)
    : triangulate(this->cells(), this->points(), 0, parallel);
  this->Result.corners = { this->Triangles.corners.data(), false, this->Triangles.corners.size() };
  this->Result.cells = this->Triangles.cells.data();
}

void BodySurface::setSpheres(const Body& body)
{
  const std::size_t count = body.radii.size();
  this->DoubleRadii = body.radii;
  this->FloatRadii.assign(body.radii.begin(), body.radii.end());
  this->Result.radius = body.radius;
  if (count > 0)
  {
    this->Result.radii = this->HasFloats
      ? lambent::ScalarSpan{ this->FloatRadii.data(), false, count }
      : lambent::ScalarSpan{ this->DoubleRadii.data(), true, count };
  }
}

lambent::TupleSpan BodySurface::points() const
{
  const std::size_t count = this->Doubles.size() / 3;
  return this->HasFloats ? lambent::TupleSpan{ this->Floats.data(), false, count }
                         : lambent::TupleSpan{ this->Doubles.data(), true, count };
}

lambent::CellSpan BodySurface::cells() const
{
  return this->HasNarrowIds
    ? lambent::CellSpan{ { this->Offsets32.data(), false, this->Offsets32.size() },
        { this->Ids32.data(), false, this->Ids32.size() } }
    : lambent::CellSpan{ { this->Offsets64.data(), true, this->Offsets64.size() },
        { this->Ids64.data(), true, this->Ids64.size() } };
}

lambent::TupleSpan BodySurface::keep(const std::vector<Vec3>& tuples, std::vector<double>& memory)
{
  for (const Vec3& t : tuples)
  {
    memory.insert(memory.end(), { t.x, t.y, t.z });
  }
  return tuples.empty() ? lambent::TupleSpan()
                        : lambent::TupleSpan{ memory.data(), true, tuples.size() };
}

lambent::CheckedFaces BodySurface::faces(const lambent::Parallel& parallel) const
{
  const lambent::CellSpan none;
  return checkFaces(this->points(), this->HasStrips ? none : this->cells(),
    this->HasStrips ? this->cells() : none, parallel);
}

std::vector<Vec3> BodySurface::pointNormals(
  lambent::Weighting how, const lambent::Parallel& parallel) const
{
  std::vector<float> normals(3 * this->points().size);
  computePointNormals(this->faces(parallel).faces, how, 1.0f, parallel, normals.data());
  std::vector<Vec3> result;
  for (std::size_t k = 0; k < normals.size(); k += 3)
  {
    result.emplace_back(normals[k], normals[k + 1], normals[k + 2]);
  }
  return result;
}

void BodySurface::addAttribute(const Body& body, const std::string& name, bool isPerCell)
{
  lambent::AttributeSpan span;
  for (const StageArray& array : body.arrays)
  {
    if (array.name == name && array.isPerCell == isPerCell)
    {
      this->Attributes.push_back(array.memory());
      span = { this->Attributes.back().data(), array.type, array.components, isPerCell };
    }
  }
  this->Result.attributes.push_back(span);
}

void BodySurface::computeNormals(const lambent::Parallel& parallel)
{
  const lambent::CheckedFaces checked = this->faces(parallel);
  this->Normals = computeCornerNormals(checked.faces, featureAngle, parallel);
  this->Result.pointNormals = { this->Normals.normals.get(), false, this->Normals.count };
  if (this->Normals.numbers)
  {
    this->NormalNumbers =
      numbersOfTriangles(checked.faces.cells, this->Normals, this->Result.corners, parallel);
    this->Result.normalNumbers = { this->NormalNumbers.data(), false, this->NormalNumbers.size() };
  }
}

Body BodySurface::withOwnCorners(const Body& body, const lambent::Parallel& parallel) const
{
  const lambent::CheckedFaces checked = this->faces(parallel);
  const lambent::CornerNormals normals =
    computeCornerNormals(checked.faces, featureAngle, parallel);
  const lambent::CellSpan& cells = checked.faces.cells;
  Body result = body;
  result.hasStrips = false;
  result.shape = Shape();
  result.pointNormals.clear();
  if (!body.arrays.empty())
  {
    throw std::runtime_error("give bodies with arrays point normals, or shade them flat");
  }
  for (std::size_t face = 0; face < lambent::cellCount(cells); ++face)
  {
    result.shape.cells.emplace_back();
    for (std::size_t place = cells.offsets[face]; place < cells.offsets[face + 1]; ++place)
    {
      const std::uint64_t point = cells.connectivity[place];
      const std::uint64_t normal =
        normals.numbers ? static_cast<std::uint64_t>(normals.numbers[place]) : point;
      const float* const n = &normals.normals[3 * normal];
      result.shape.cells.back().push_back(static_cast<std::int64_t>(result.shape.points.size()));
      result.shape.points.push_back(body.shape.points[point]);
      result.pointNormals.emplace_back(n[0], n[1], n[2]);
    }
  }
  return result;
}
