// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BodySurface.h"

#include "CellEdgeFlags.h"
#include "CellSizes.h"
#include "CellView.h"
#include "TriangleNormals.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace
{
constexpr double featureAngle = 30.0; // the ray tracer's default
}

BodySurface::BodySurface(const Body& body, const lambent::Parallel& parallel)
  : HasFloats(body.hasFloatPoints)
  , HasNarrowIds(body.has32BitIds)
  , HasStrips(body.hasStrips)
  , Placement(body.transform)
  , PlacementOfNormals(body.transform)
{
  this->setPoints(body, parallel);
  if (body.hasSpheres())
  {
    this->setSpheres(body);
  }
  else if (!body.hasFaces())
  {
    this->setLines(body, parallel);
  }
  else
  {
    this->setCells(body, parallel);
    this->chooseTriangles(body, parallel);
  }
  this->Result.pointNormals = this->keepNormals(body.pointNormals, this->PointNormals);
  if (body.appearance.shading == lambent::Shading::Flat)
  {
    this->Result.cellNormals = this->keepNormals(body.cellNormals, this->CellNormals);
  }
  this->Result.appearance = body.appearance;
  if (!body.colors.array.empty())
  {
    this->setColors(body);
  }
  if (body.texture.exists())
  {
    this->setTexture(body.texture);
  }
}

void BodySurface::setTexture(const StageTexture& texture)
{
  this->Pixels = texture.pixels.memory();
  this->Places = texture.coordinates.memory();
  lambent::Texture& result = this->Map.texture;
  result.pixels = { this->Pixels.data(), texture.pixels.type, texture.pixels.components, false };
  result.width = texture.width;
  result.height = texture.height;
  result.wrap = texture.wrap;
  result.isInterpolated = texture.isInterpolated;
  result.isSRGB = texture.isSRGB;
  result.border = { texture.border, 1.0 };
  for (int row = 0; row < 2; ++row)
  {
    std::copy_n(texture.matrix[row], 3, result.matrix[row]);
  }
  this->Map.coordinates = { this->Places.data(), texture.coordinates.type,
    texture.coordinates.components, false };
  result.hasAlpha = result.isAnyTransparent();
  this->Result.texture = &this->Map;
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
  this->Colors.hasAlpha = colors.hasAlpha;
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

void BodySurface::setPoints(const Body& body, const lambent::Parallel& parallel)
{
  for (const Vec3& p : body.shape.points)
  {
    this->Doubles.insert(this->Doubles.end(), { p.x, p.y, p.z });
  }
  this->Floats.assign(this->Doubles.begin(), this->Doubles.end());
  const std::size_t count = body.shape.points.size();
  this->Result.points = this->HasFloats ? lambent::TupleSpan{ this->Floats.data(), false, count }
                                        : lambent::TupleSpan{ this->Doubles.data(), true, count };
  if (!this->Placement.isIdentity())
  {
    this->Placed.resize(this->Doubles.size());
    transformPoints(this->Placement, this->Result.points, parallel, this->Placed.data());
    this->Result.points = { this->Placed.data(), true, count };
  }
}

void BodySurface::copyCells(const Body& body)
{
  this->Offsets64.push_back(0);
  for (const auto& cell : body.shape.cells)
  {
    this->Ids64.insert(this->Ids64.end(), cell.begin(), cell.end());
    this->Offsets64.push_back(static_cast<std::int64_t>(this->Ids64.size()));
  }
  this->Ids32.assign(this->Ids64.begin(), this->Ids64.end());
  this->Offsets32.assign(this->Offsets64.begin(), this->Offsets64.end());
}

// As for polydata: a list of triangles is used in place, all other cells are triangulated.
void BodySurface::setCells(const Body& body, const lambent::Parallel& parallel)
{
  this->copyCells(body);
  if (!this->HasStrips && inspect(this->cells(), parallel) == lambent::CellSizes::Triangles)
  {
    this->Result.corners = this->cells().connectivity;
    return;
  }
  lambent::MergedFaces merged;
  if (this->HasStrips)
  {
    merged = mergeFaces(lambent::CellSpan(), this->cells(), parallel);
  }
  this->Triangles = this->HasStrips ? triangulate(merged, this->Result.points, 0, parallel)
                                    : triangulate(this->cells(), this->Result.points, 0, parallel);
  this->Result.corners = { this->Triangles.corners.data(), false, this->Triangles.corners.size() };
  this->Result.cells = this->Triangles.cells.data();
  if (body.appearance.edges.areVisible)
  {
    this->CellEdges =
      findCellEdges(this->HasStrips ? merged.span() : this->cells(), this->Triangles, parallel);
    this->Result.cellEdges = this->CellEdges.data();
  }
}

void BodySurface::setLines(const Body& body, const lambent::Parallel& parallel)
{
  this->copyCells(body);
  this->findUses(body, parallel);
  const std::size_t points = this->Result.points.size;
  const lambent::CellUse* const uses = this->Uses.empty() ? nullptr : this->Uses.data();
  const lambent::CellGroup all{ this->cells(), 0, uses };
  switch (body.show)
  {
    case CellShow::Vertices:
      addVertices(all, this->Lines);
      break;
    case CellShow::Polylines:
      addPolylines(all, this->Lines);
      break;
    case CellShow::Edges:
      addEdges({ this->polygons(), 0, uses }, { this->strips(), 0, uses }, points, this->Lines);
      break;
    default:
      addUsedPoints({ all }, points, this->Lines);
  }
  this->Result.corners = { this->Lines.corners.data(), true, this->Lines.corners.size() };
  this->Result.cells = this->Lines.cells.data();
  this->Result.width = body.width;
  this->Result.isRounded = body.isRounded;
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

void BodySurface::findUses(const Body& body, const lambent::Parallel& parallel)
{
  const auto dataOf = [](const std::vector<unsigned char>& flags)
  { return flags.empty() ? nullptr : flags.data(); };
  this->Uses = findCellUses(this->polygons(), this->strips(), this->Result.points.size,
    { dataOf(body.pointGhosts), dataOf(body.cellGhosts) }, parallel);
}

void BodySurface::chooseTriangles(const Body& body, const lambent::Parallel& parallel)
{
  this->AllCorners = this->Result.corners;
  this->findUses(body, parallel);
  this->Drawn = lambent::DrawnTriangles(this->AllCorners.size / 3, this->Result.cells, 0,
    this->Uses, this->PlacementOfNormals.isMirror(), parallel);
  if (!this->Drawn.areUnchanged())
  {
    this->DrawnCorners = this->Drawn.pick(this->AllCorners, parallel);
    this->Result.corners = this->DrawnCorners.span();
    this->Result.cells = this->Uses.empty() ? this->Result.cells : this->Drawn.cells().data();
    if (this->Result.cellEdges)
    {
      this->CellEdges = this->Drawn.pickEdges(this->CellEdges, parallel);
      this->Result.cellEdges = this->CellEdges.data();
    }
  }
}

lambent::CellSpan BodySurface::cells() const
{
  return this->HasNarrowIds
    ? lambent::CellSpan{ { this->Offsets32.data(), false, this->Offsets32.size() },
        { this->Ids32.data(), false, this->Ids32.size() } }
    : lambent::CellSpan{ { this->Offsets64.data(), true, this->Offsets64.size() },
        { this->Ids64.data(), true, this->Ids64.size() } };
}

lambent::CellSpan BodySurface::polygons() const
{
  return this->HasStrips ? lambent::CellSpan() : this->cells();
}

lambent::CellSpan BodySurface::strips() const
{
  return this->HasStrips ? this->cells() : lambent::CellSpan();
}

lambent::TupleSpan BodySurface::keepNormals(
  const std::vector<Vec3>& normals, std::vector<double>& memory) const
{
  for (const Vec3& given : normals)
  {
    const Vec3 n = this->Placement.isIdentity() ? given : this->PlacementOfNormals(given);
    memory.insert(memory.end(), { n.x, n.y, n.z });
  }
  return normals.empty() ? lambent::TupleSpan()
                         : lambent::TupleSpan{ memory.data(), true, normals.size() };
}

lambent::CheckedFaces BodySurface::faces(const lambent::Parallel& parallel) const
{
  lambent::CheckedFaces result =
    checkFaces(this->Result.points, this->polygons(), this->strips(), parallel);
  skipUnused(this->Uses, result);
  return result;
}

std::vector<Vec3> BodySurface::pointNormals(
  lambent::Weighting how, const lambent::Parallel& parallel) const
{
  std::vector<float> normals(3 * this->Result.points.size);
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

lambent::CornerNormals BodySurface::cornerNormals(
  const lambent::CheckedFaces& faces, const lambent::Parallel& parallel) const
{
  lambent::CornerNormals normals = computeCornerNormals(faces.faces, featureAngle, parallel);
  for (std::size_t k = 0; this->PlacementOfNormals.isMirror() && k < 3 * normals.count; ++k)
  {
    normals.normals[k] = -normals.normals[k];
  }
  return normals;
}

void BodySurface::computeNormals(const lambent::Parallel& parallel)
{
  const lambent::CheckedFaces checked = this->faces(parallel);
  this->Normals = this->cornerNormals(checked, parallel);
  this->Result.pointNormals = { this->Normals.normals.get(), false, this->Normals.count };
  if (this->Normals.numbers)
  {
    this->NormalNumbers =
      numbersOfTriangles(checked.faces.cells, this->Normals, this->AllCorners, parallel);
    this->Result.normalNumbers = { this->NormalNumbers.data(), false, this->NormalNumbers.size() };
    if (!this->Drawn.areUnchanged())
    {
      this->DrawnNumbers = this->Drawn.pick(this->Result.normalNumbers, parallel);
      this->Result.normalNumbers = this->DrawnNumbers.span();
    }
  }
}

Body BodySurface::withOwnCorners(const Body& body, const lambent::Parallel& parallel) const
{
  const lambent::CheckedFaces checked = this->faces(parallel);
  const lambent::CornerNormals normals = this->cornerNormals(checked, parallel);
  const lambent::CellSpan& cells = checked.faces.cells;
  Body result = body;
  result.hasStrips = false;
  result.hasFloatPoints = body.hasFloatPoints && this->Placement.isIdentity();
  result.transform = lambent::Transform();
  result.shape = Shape();
  result.pointNormals.clear();
  result.pointGhosts.clear();
  result.cellGhosts.clear();
  if (!body.arrays.empty() || body.texture.exists())
  {
    throw std::runtime_error("give bodies with arrays point normals, or shade them flat");
  }
  for (std::size_t face = 0; face < lambent::cellCount(cells); ++face)
  {
    const std::int64_t cell = checked.cellOf(static_cast<std::int64_t>(face));
    if (!this->Uses.empty() &&
      this->Uses[static_cast<std::size_t>(cell)] != lambent::CellUse::Drawn)
    {
      continue;
    }
    result.shape.cells.emplace_back();
    for (std::size_t place = cells.offsets[face]; place < cells.offsets[face + 1]; ++place)
    {
      const std::uint64_t point = cells.connectivity[place];
      const std::uint64_t normal =
        normals.numbers ? static_cast<std::uint64_t>(normals.numbers[place]) : point;
      const float* const n = &normals.normals[3 * normal];
      result.shape.cells.back().push_back(static_cast<std::int64_t>(result.shape.points.size()));
      result.shape.points.push_back(this->Result.points[point]);
      result.pointNormals.emplace_back(n[0], n[1], n[2]);
    }
    if (this->PlacementOfNormals.isMirror())
    {
      std::swap(result.shape.cells.back()[1], result.shape.cells.back()[2]);
    }
  }
  return result;
}
