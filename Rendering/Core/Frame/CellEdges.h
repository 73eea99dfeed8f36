// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief which samples show an edge of the cell that they see
 *
 * The rule is that of EdgeLines.h, for all edges of a cell: those of its consecutive triangles that
 * the surface marks as edges (Surface::cellEdges).
 *
 * CellEdges::isAt() is the definition and projects the whole cell for each sample. EdgesInTile
 * keeps projected edges for the samples of a tile:
 *
 * 1. The edges of the cell seen last are kept, since its samples are neighbours.
 * 2. Those of cells with many triangles, such as strips, are kept until the tile ends.
 * 3. Edges that are too far from the tile for any of its samples are dropped. The bound is larger
 *    than half the width by more than the rounding errors of squaredDistance().
 */
#ifndef lambent_CellEdges_h
#define lambent_CellEdges_h

#include "EdgeLines.h"
#include "FrameMesh.h"

#include <map>
#include <vector>

namespace lambent
{
class CellEdges
{
public:
  explicit CellEdges(const FrameMesh& mesh)
    : Mesh(mesh)
    , HalfPixel(0.5 * mesh.frame().samplesPerPixel * mesh.frame().pixel)
  {
  }

  /// Whether the sample at (x, y), which sees this primitive, shows an edge. Edges must be visible.
  bool isAt(std::uint32_t primitive, double x, double y) const;

  /// The colour of a sample that sees this primitive, given its colour without edges.
  Vec3 mixed(std::uint32_t primitive, double x, double y, const Vec3& lit) const;

  /// Half the width of a line on the image plane.
  double halfWidth(const EdgeStyle& style) const { return style.width * this->HalfPixel; }

  /// Consecutive triangles, counted over all surfaces.
  struct Range
  {
    std::uint32_t begin, end;
    bool holds(std::uint32_t triangle) const { return triangle - begin < end - begin; }
  };
  /// The triangles of the cell that a triangle belongs to.
  static Range cellOf(const SceneMesh::Part& part, std::uint32_t triangle);

  /// Calls body(line) for each edge of some triangles of a part.
  template <typename Body>
  void forLines(const SceneMesh::Part& part, const Range& triangles, const Body& body) const
  {
    for (std::uint32_t number = triangles.begin; number < triangles.end; ++number)
    {
      const std::size_t triangle = number - part.firstPrimitive;
      const unsigned char* const flags = part.surface->cellEdges;
      const unsigned int edges = flags ? flags[triangle] : 7u;
      const FrameTriangle t = this->Mesh.triangle(part, number);
      const FramePoint* const corners[4] = { &t.a, &t.b, &t.c, &t.a };
      for (int k = 0; k < 3; ++k)
      {
        EdgeLine line{};
        if ((edges >> k & 1u) != 0 &&
          projectEdge(*corners[k], *corners[k + 1], this->Mesh.frame().parallel, line))
        {
          body(line);
        }
      }
    }
  }

  const SceneMesh& mesh() const { return this->Mesh.mesh(); }

private:
  const FrameMesh& Mesh;
  double HalfPixel; ///< half the side of a pixel on the image plane
};

/// A worker's memory.
class EdgesInTile
{
public:
  /// Begins a tile whose samples lie between these positions on the image plane.
  void reset(double x0, double x1, double y0, double y1);

  /// The edges near the tile of the cell that a triangle of the part belongs to. Valid until the
  /// next call.
  const std::vector<EdgeLine>& near(
    const CellEdges& edges, const SceneMesh::Part& part, std::uint32_t triangle);

private:
  struct Cell
  {
    CellEdges::Range triangles{ 0, 0 };
    std::vector<EdgeLine> lines;
  };
  void load(const CellEdges& edges, const SceneMesh::Part& part, Cell& cell) const;

  double X0 = 0.0, X1 = 0.0, Y0 = 0.0, Y1 = 0.0;
  Cell Last;
  std::map<std::uint32_t, Cell> Large; ///< by their first triangles
};
}

#endif
