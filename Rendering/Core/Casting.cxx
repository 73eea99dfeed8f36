// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting.h"

#include "CastingKernel.h"

#include <hwy/cache_control.h>

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

Window Casting::boxIn(
  const CellRays& rays, const CellGrid::Level& level, const BinEntry& entry) const
{
  const Window& cell = rays.window();
  const Window bin = this->Grid.window(level, cell.i0, cell.j0);
  const int unit = level.unitShift;
  const Window box =
    intersection({ bin.i0 + (entry.i0 << unit), bin.i0 + ((entry.i1 + 1) << unit),
                   bin.j0 + (entry.j0 << unit), bin.j0 + ((entry.j1 + 1) << unit) },
      cell);
  return { box.i0 - cell.i0, box.i1 - cell.i0, box.j0 - cell.j0, box.j1 - cell.j0 };
}

Casting::Triangle Casting::triangle(std::uint32_t number) const
{
  const Mesh::Part& part = this->Triangles.partOf(number);
  const Surface& surface = *part.surface;
  const std::size_t first = 3 * (number - part.firstTriangle);
  const auto corner = [&](std::size_t k)
  { return this->Frame.toFrame(surface.points[surface.corners[first + k]]); };
  return { corner(0), corner(1), corner(2), surface.material.cullFront, surface.material.cullBack };
}

bool Casting::misses(const Triangle& t, const CellRays& rays, const Window& box) const
{
  const double x[2] = { rays.xs()[box.i0], rays.xs()[box.i1 - 1] };
  const double y[2] = { rays.ys()[box.j0], rays.ys()[box.j1 - 1] };
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

bool Casting::hits(std::uint32_t number, double x, double y, double& depth) const
{
  const Triangle t = this->triangle(number);
  Hit hit{};
  const bool isHit = intersect(t.a, t.b, t.c, x, y, hit) && !(t.cullFront && hit.sum > 0.0) &&
    !(t.cullBack && hit.sum < 0.0);
  depth = hit.depth;
  return isHit;
}

void Casting::castPlainly(
  const BinEntry* entries, int count, const CellGrid::Level& level, CellRays& rays) const
{
  for (int k = 0; k < count; ++k)
  {
    const BinEntry& entry = entries[k];
    const Window box = this->boxIn(rays, level, entry);
    if (!box.empty())
    {
      this->test(this->triangle(entry.triangle), entry.triangle, box, rays);
    }
  }
}

void Casting::test(const Triangle& t, std::uint32_t number, const Window& box, CellRays& rays) const
{
  for (int j = box.j0; j < box.j1; ++j)
  {
    for (int i = box.i0; i < box.i1; ++i)
    {
      Hit hit;
      if (intersect(t.a, t.b, t.c, rays.xs()[i], rays.ys()[j], hit) &&
        !(t.cullFront && hit.sum > 0.0) && !(t.cullBack && hit.sum < 0.0))
      {
        rays.offer(static_cast<std::size_t>(j) * rays.stride() + i, hit.depth, number);
      }
    }
  }
}

void Casting::cast(const BinEntry* entries, int count, const CellGrid::Level& level, CellRays& rays,
  CastBatch& batch) const
{
  Candidate candidates[PagedBins<BinEntry>::pageCapacity];
  this->fetch(entries, count, candidates);
  const bool isFinest = this->Grid.isFinest(level);
  for (int k = 0; k < count; ++k)
  {
    const BinEntry& entry = entries[k];
    const Window box = this->boxIn(rays, level, entry);
    if (isFinest || (!box.empty() && !this->misses(this->triangle(entry.triangle), rays, box)))
    {
      this->add(entry.triangle, candidates[k], box, isFinest, rays, batch);
    }
  }
}

// Points lie anywhere in memory: all of a page's are asked for before the first is
// read.
void Casting::fetch(const BinEntry* entries, int count, Candidate* candidates) const
{
  for (int k = 0; k < count; ++k)
  {
    const std::uint32_t number = entries[k].triangle;
    const Mesh::Part& part = this->Triangles.partOf(number);
    candidates[k].surface = part.surface;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      candidates[k].corners[corner] =
        part.surface->corners[3 * (number - part.firstTriangle) + corner];
      hwy::Prefetch(part.surface->points.at(candidates[k].corners[corner]));
    }
  }
}

void Casting::add(std::uint32_t number, const Candidate& candidate, const Window& box,
  bool isBoxExact, CellRays& rays, CastBatch& batch) const
{
  for (int corner = 0; corner < 3; ++corner)
  {
    const Vec3 p = candidate.surface->points[candidate.corners[corner]];
    batch.points[3 * corner][batch.count] = p.x;
    batch.points[3 * corner + 1][batch.count] = p.y;
    batch.points[3 * corner + 2][batch.count] = p.z;
  }
  batch.triangles[batch.count] = number;
  batch.boxes[batch.count] = box;
  batch.isBoxExact[batch.count] = isBoxExact;
  batch.cullFront[batch.count] = candidate.surface->material.cullFront;
  batch.cullBack[batch.count] = candidate.surface->material.cullBack;
  if (++batch.count == CastBatch::capacity)
  {
    this->flush(rays, batch);
  }
}

void Casting::flush(CellRays& rays, CastBatch& batch) const
{
  castBatch(this->Frame, batch, rays);
  batch.count = 0;
}

double Casting::depthAt(std::int64_t triangle, const CellRays& rays, std::size_t ray) const
{
  double depth;
  this->hits(static_cast<std::uint32_t>(triangle), rays.x(ray), rays.y(ray), depth);
  return depth;
}

void Casting::addHits(const Fragment* hits, int count, CellRays& rays) const
{
  for (int k = 0; k < count; ++k)
  {
    const Fragment& hit = hits[k];
    CellRays::Range& nearest = rays.ranges()[hit.ray];
    if (hit.near > nearest.far)
    {
      continue;
    }
    bool isNearer = hit.far < nearest.near || nearest.triangle == CellRays::none;
    if (!isNearer)
    {
      const double depth = this->depthAt(hit.triangle, rays, hit.ray);
      const double other = this->depthAt(nearest.triangle, rays, hit.ray);
      isNearer = depth < other || (depth == other && hit.triangle < nearest.triangle);
    }
    if (isNearer)
    {
      nearest = { hit.near, hit.far, hit.triangle };
    }
  }
}

void Casting::settle(CellRays& rays, bool withDepths) const
{
  for (std::size_t ray = 0; ray < rays.size(); ++ray)
  {
    const CellRays::Range& hit = rays.ranges()[ray];
    const double depth = rays.depths()[ray];
    if (hit.triangle == CellRays::none || depth < hit.near)
    {
      continue;
    }
    if (!withDepths && depth > hit.far)
    {
      rays.triangles()[ray] = hit.triangle;
    }
    else
    {
      rays.offer(ray, this->depthAt(hit.triangle, rays, ray), hit.triangle);
    }
  }
}
}
