// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LinesFromVTK.h"

#include "CellBlocks.h"
#include "CellView.h"
#include "Chunks.h"
#include "MissingPoint.h"
#include "Vec3FromVTK.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace lambent::adapters
{
namespace
{
/// Throws if lines or points of that width cannot be drawn. `what` begins the message.
void checkWidth(double width, const char* what, const char* method)
{
  if (width > 0.0 && std::isfinite(width))
  {
    return;
  }
  std::ostringstream text;
  text << what << " is " << width
       << ", but it must be a finite number of pixels above 0. Call vtkProperty::" << method
       << "().";
  throw std::runtime_error(text.str());
}

}

LineStyle lineStyleFromVTK(vtkProperty* property)
{
  LineStyle result;
  if (!property)
  {
    return result;
  }
  result.representation = property->GetRepresentation() == VTK_WIREFRAME ? LineStyle::Wireframe
    : property->GetRepresentation() == VTK_POINTS                        ? LineStyle::Points
                                                                         : LineStyle::Surface;
  result.lineWidth = property->GetLineWidth();
  result.pointSize = property->GetPointSize();
  result.linesAreTubes = property->GetRenderLinesAsTubes();
  result.pointsAreSpheres = property->GetRenderPointsAsSpheres();
  result.hasVertices = property->GetVertexVisibility() != 0;
  result.vertexColor = vec3FromVTK(property->GetVertexColor());
  return result;
}

LinesFromVTK::LinesFromVTK(vtkPolyData* input, const TupleSpan& points,
  const Appearance& appearance, const LineStyle& style, SpansFromVTK& spans,
  const Parallel& parallel)
  : AllPoints(points)
  , Look(appearance)
  , UsesFaces(style.hasVertices || style.representation != LineStyle::Surface)
{
  this->Look.cullFront = this->Look.cullBack = false;
  if (!this->UsesFaces && input->GetNumberOfVerts() + input->GetNumberOfLines() == 0)
  {
    return; // there are neither lines nor points
  }
  this->setGroups(input, spans);
  this->check(this->Vertices, "vertices", Share(parallel, 0.0, 0.1));
  this->check(this->Lines, "lines", Share(parallel, 0.1, 0.2));
  this->check(this->Polygons, "polygons", Share(parallel, 0.2, 0.5));
  this->check(this->Strips, "strips", Share(parallel, 0.5, 0.6));
  this->setUses(input, Share(parallel, 0.6, 1.0));
  this->addSurfaces(style);
}

/// Polygons and strips only if they are needed.
void LinesFromVTK::setGroups(vtkPolyData* input, SpansFromVTK& spans)
{
  this->Vertices.cells = spans.cells(input->GetVerts());
  this->Lines.cells = spans.cells(input->GetLines());
  this->Lines.firstCell = input->GetNumberOfVerts();
  if (this->UsesFaces)
  {
    this->Polygons.cells = spans.cells(input->GetPolys());
    this->Strips.cells = spans.cells(input->GetStrips());
    this->Polygons.firstCell = this->Lines.firstCell + input->GetNumberOfLines();
    this->Strips.firstCell = this->Polygons.firstCell + input->GetNumberOfPolys();
  }
}

void LinesFromVTK::check(const CellGroup& group, const char* kind, const Parallel& parallel) const
{
  const CellDefect defect = checkCells(group.cells, this->AllPoints.size, parallel).defect;
  if (defect.kind == CellDefect::Offsets)
  {
    throw std::runtime_error(std::string("the offsets of the ") + kind +
      " decrease or reach beyond their connectivity. Rebuild the vtkCellArray, for instance with "
      "InsertNextCell().");
  }
  if (defect)
  {
    throw std::runtime_error("cell " +
      std::to_string(group.firstCell + static_cast<std::int64_t>(defect.cell)) + " " +
      describeMissingPoint(defect.point, static_cast<vtkIdType>(this->AllPoints.size)));
  }
}

void LinesFromVTK::setUses(vtkPolyData* input, const Parallel& parallel)
{
  GhostFlags ghosts = ghostsFromVTK(input);
  const std::size_t points = this->AllPoints.size;
  this->Uses[1] = findCellUses(
    this->Polygons.cells, this->Strips.cells, points, ghosts, Share(parallel, 0.0, 0.5));
  ghosts.cells -= ghosts.cells ? input->GetNumberOfVerts() + input->GetNumberOfLines() : 0;
  this->Uses[0] = findCellUses(
    this->Vertices.cells, this->Lines.cells, points, ghosts, Share(parallel, 0.5, 1.0));
  const auto setUses = [](const UnwrittenVector<CellUse>& uses, CellGroup& first, CellGroup& second)
  {
    if (!uses.empty())
    {
      first.uses = uses.data();
      second.uses = uses.data() + cellCount(first.cells);
    }
  };
  setUses(this->Uses[0], this->Vertices, this->Lines);
  setUses(this->Uses[1], this->Polygons, this->Strips);
}

void LinesFromVTK::addSurfaces(const LineStyle& style)
{
  if (style.hasVertices)
  {
    this->addMarks(style);
  }
  if (style.representation == LineStyle::Points)
  {
    this->addPoints(this->usedPoints(), style);
    return;
  }
  LineList vertices, lines;
  addVertices(this->Vertices, vertices);
  addPolylines(this->Lines, lines);
  if (style.representation == LineStyle::Wireframe)
  {
    addEdges(this->Polygons, this->Strips, this->AllPoints.size, lines);
  }
  this->addPoints(std::move(vertices), style);
  this->addLines(std::move(lines), style);
}

/// As in VTK, vertices have their colour without light, unless they are spheres.
void LinesFromVTK::addMarks(const LineStyle& style)
{
  if (!isFinite(style.vertexColor))
  {
    throw std::runtime_error("the colour of vertices has a channel that is not a finite number. "
                             "Call vtkProperty::SetVertexColor() with finite ones.");
  }
  if (Surface* const marks = this->addPoints(this->usedPoints(), style))
  {
    Appearance& look = marks->appearance;
    look.diffuseColor = look.ambientColor = style.vertexColor;
    look.shading = style.pointsAreSpheres ? look.shading : Shading::Unlit;
    this->Marks = marks;
  }
}

LineList LinesFromVTK::usedPoints() const
{
  LineList result;
  addUsedPoints(
    { this->Vertices, this->Lines, this->Polygons, this->Strips }, this->AllPoints.size, result);
  return result;
}

Surface* LinesFromVTK::addPoints(LineList&& list, const LineStyle& style)
{
  if (list.cells.empty())
  {
    return nullptr;
  }
  checkWidth(style.pointSize, "the size of points", "SetPointSize");
  return this->add(std::move(list), style.pointSize, style.pointsAreSpheres);
}

Surface* LinesFromVTK::addLines(LineList&& list, const LineStyle& style)
{
  if (list.cells.empty())
  {
    return nullptr;
  }
  checkWidth(style.lineWidth, "the width of lines", "SetLineWidth");
  return this->add(std::move(list), style.lineWidth, style.linesAreTubes);
}

Surface* LinesFromVTK::add(LineList&& list, double width, bool isRounded)
{
  this->Lists.push_back(std::make_unique<LineList>(std::move(list)));
  this->Surfaces.push_back(std::make_unique<Surface>());
  const LineList& lines = *this->Lists.back();
  Surface& surface = *this->Surfaces.back();
  surface.points = this->AllPoints;
  surface.corners = { lines.corners.data(), true, lines.corners.size() };
  surface.cells = lines.cells.data();
  surface.width = width;
  surface.isRounded = isRounded;
  surface.appearance = this->Look;
  return &surface;
}

void LinesFromVTK::append(
  const Surface& faces, const TupleSpan& normals, std::vector<Surface>& to) const
{
  for (const std::unique_ptr<Surface>& lines : this->Surfaces)
  {
    to.push_back(*lines);
    to.back().attributes = faces.attributes;
    to.back().pointNormals = normals;
    to.back().colors = lines.get() == this->Marks ? nullptr : faces.colors;
  }
}
}
