// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellEdges.h"

#include <iterator>

namespace lambent
{
namespace
{
/// Cells with more triangles are kept until the tile ends.
constexpr std::uint32_t mostTrianglesOfSmall = 8;

/// False only if no point of the rectangle is within this distance of the line. NaN gives true.
bool mayTouch(const EdgeLine& line, double x0, double x1, double y0, double y1, double distance)
{
  const double size = std::max({ std::fabs(line.ax), std::fabs(line.ay), std::fabs(line.bx),
    std::fabs(line.by), std::fabs(x0), std::fabs(x1), std::fabs(y0), std::fabs(y1) });
  const double most = distance * (1.0 + 0x1p-20) + size * 0x1p-40;
  return !(std::max(line.ax, line.bx) + most < x0 || std::min(line.ax, line.bx) - most > x1 ||
    std::max(line.ay, line.by) + most < y0 || std::min(line.ay, line.by) - most > y1);
}
}

CellEdges::Range CellEdges::cellOf(const SceneMesh::Part& part, std::uint32_t triangle)
{
  const std::int64_t* const cells = part.surface->cells;
  Range range{ triangle, triangle + 1 };
  if (cells)
  {
    const std::uint32_t first = part.firstPrimitive, end = first + part.primitiveCount;
    const std::int64_t cell = cells[triangle - first];
    while (range.begin > first && cells[range.begin - 1 - first] == cell)
    {
      --range.begin;
    }
    while (range.end < end && cells[range.end - first] == cell)
    {
      ++range.end;
    }
  }
  return range;
}

bool CellEdges::isAt(std::uint32_t primitive, double x, double y) const
{
  const SceneMesh::Part& part = this->mesh().partOf(primitive);
  const double half = this->halfWidth(part.appearance->edges);
  bool result = false;
  this->forLines(part, cellOf(part, primitive),
    [&](const EdgeLine& line) { result = result || line.isAt(x, y, half * half); });
  return result;
}

Vec3 CellEdges::mixed(std::uint32_t primitive, double x, double y, const Vec3& lit) const
{
  const SceneMesh::Part& part = this->mesh().partOf(primitive);
  const EdgeStyle& style = part.appearance->edges;
  return part.hasEdges() && this->isAt(primitive, x, y)
    ? mixedWithEdge(lit, style.color, style.opacity)
    : lit;
}

void EdgesInTile::reset(double x0, double x1, double y0, double y1)
{
  this->X0 = x0;
  this->X1 = x1;
  this->Y0 = y0;
  this->Y1 = y1;
  this->Last.triangles = { 0, 0 };
  this->Large.clear();
}

void EdgesInTile::load(const CellEdges& edges, const SceneMesh::Part& part, Cell& cell) const
{
  const double half = edges.halfWidth(part.appearance->edges);
  cell.lines.clear();
  edges.forLines(part, cell.triangles,
    [&](const EdgeLine& line)
    {
      if (mayTouch(line, this->X0, this->X1, this->Y0, this->Y1, half))
      {
        cell.lines.push_back(line);
      }
    });
}

const std::vector<EdgeLine>& EdgesInTile::near(
  const CellEdges& edges, const SceneMesh::Part& part, std::uint32_t triangle)
{
  if (this->Last.triangles.holds(triangle))
  {
    return this->Last.lines;
  }
  const auto after = this->Large.upper_bound(triangle);
  if (after != this->Large.begin() && std::prev(after)->second.triangles.holds(triangle))
  {
    return std::prev(after)->second.lines;
  }
  const CellEdges::Range triangles = CellEdges::cellOf(part, triangle);
  const bool isLarge = triangles.end - triangles.begin > mostTrianglesOfSmall;
  Cell& cell = isLarge ? this->Large[triangles.begin] : this->Last;
  cell.triangles = triangles;
  this->load(edges, part, cell);
  return cell.lines;
}
}
