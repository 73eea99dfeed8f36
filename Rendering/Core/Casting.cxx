// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting.h"

namespace lambent
{
namespace
{
/// An edge function over a rectangle of the image plane: it is affine there, so
/// its range is that of the four corners. The error bounds the roundings both of
/// the corners and of the edge functions that intersect() computes within: each
/// is a difference of two products of sheared coordinates, all of them bounded by
/// the m below, with fewer than 16 roundings of 2^-53.
struct EdgeRange
{
  double corners[4];
  double error;

  bool isBelow() const
  {
    return std::max(std::max(this->corners[0], this->corners[1]),
             std::max(this->corners[2], this->corners[3])) < -this->error;
  }
  bool isAbove() const
  {
    return std::min(std::min(this->corners[0], this->corners[1]),
             std::min(this->corners[2], this->corners[3])) > this->error;
  }
};

EdgeRange edgeRange(const FramePoint& p, const FramePoint& q, const double x[2], const double y[2])
{
  const double constant = p.x * q.y - p.y * q.x;
  const double perX = p.y * q.w - p.w * q.y;
  const double perY = p.w * q.x - p.x * q.w;
  EdgeRange range;
  for (int k = 0; k < 4; ++k)
  {
    range.corners[k] = constant + x[k & 1] * perX + y[k >> 1] * perY;
  }
  const double xMax = std::max(std::fabs(x[0]), std::fabs(x[1]));
  const double yMax = std::max(std::fabs(y[0]), std::fabs(y[1]));
  const double mpx = std::fabs(p.x) + xMax * std::fabs(p.w);
  const double mpy = std::fabs(p.y) + yMax * std::fabs(p.w);
  const double mqx = std::fabs(q.x) + xMax * std::fabs(q.w);
  const double mqy = std::fabs(q.y) + yMax * std::fabs(q.w);
  range.error = std::ldexp(mpx * mqy + mpy * mqx, -48) + std::numeric_limits<double>::min();
  return range;
}
}

void Casting::run(const BinPage& page, const CellGrid::Level& level, int column, int row,
  NearestHits& hits) const
{
  const bool isCoarse = level.first != 0;
  const Window bin = this->Grid.window(level, column, row);
  for (int k = 0; k < page.count; ++k)
  {
    const BinEntry& entry = page.entries[k];
    const Window box{ bin.i0 + entry.i0 * level.unit, bin.i0 + (entry.i1 + 1) * level.unit,
      bin.j0 + entry.j0 * level.unit, bin.j0 + (entry.j1 + 1) * level.unit };
    const Window rays = intersection(box, hits.window());
    if (rays.empty())
    {
      continue;
    }
    const Triangle candidate = this->triangle(entry.triangle);
    if (!isCoarse || !this->misses(candidate, rays))
    {
      this->test(candidate, entry.triangle, rays, hits);
    }
  }
}

Casting::Triangle Casting::triangle(std::uint32_t number) const
{
  const Mesh::Part& part = this->Triangles.partOf(number);
  const Surface& surface = *part.surface;
  const std::size_t first = 3 * (number - part.firstTriangle);
  const auto corner = [&](std::size_t k) {
    return this->Frame.toFrame(surface.points[surface.corners[first + k]]);
  };
  return { corner(0), corner(1), corner(2), surface.material.cullFront, surface.material.cullBack };
}

bool Casting::misses(const Triangle& t, const Window& rays) const
{
  const double x[2] = { this->Frame.x(this->Image.i0 + rays.i0),
    this->Frame.x(this->Image.i0 + rays.i1 - 1) };
  const double y[2] = { this->Frame.y(this->Image.j0 + rays.j0),
    this->Frame.y(this->Image.j0 + rays.j1 - 1) };
  const EdgeRange edges[3] = { edgeRange(t.b, t.c, x, y), edgeRange(t.c, t.a, x, y),
    edgeRange(t.a, t.b, x, y) };
  EdgeRange sum;
  for (int k = 0; k < 4; ++k)
  {
    sum.corners[k] = edges[0].corners[k] + edges[1].corners[k] + edges[2].corners[k];
  }
  sum.error = 2.0 * (edges[0].error + edges[1].error + edges[2].error);
  const bool front = sum.isAbove(), back = sum.isBelow();
  for (const EdgeRange& edge : edges)
  {
    if ((front && edge.isBelow()) || (back && edge.isAbove()))
    {
      return true;
    }
  }
  return false;
}

void Casting::test(const Triangle& t, std::uint32_t number, const Window& rays,
  NearestHits& hits) const
{
  for (int j = rays.j0; j < rays.j1; ++j)
  {
    const double y = this->Frame.y(this->Image.j0 + j);
    std::size_t index = hits.index(rays.i0, j);
    for (int i = rays.i0; i < rays.i1; ++i, ++index)
    {
      Hit hit;
      if (intersect(t.a, t.b, t.c, this->Frame.x(this->Image.i0 + i), y, hit) &&
        !(t.cullFront && hit.sum > 0.0) && !(t.cullBack && hit.sum < 0.0))
      {
        hits.offer(index, hit.depth, number);
      }
    }
  }
}
}
