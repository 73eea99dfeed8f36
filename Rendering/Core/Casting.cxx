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
  const Window box = intersection({ bin.i0 + (entry.i0 << unit), bin.i0 + ((entry.i1 + 1) << unit),
                                    bin.j0 + (entry.j0 << unit), bin.j0 + ((entry.j1 + 1) << unit) },
    cell);
  return { box.i0 - cell.i0, box.i1 - cell.i0, box.j0 - cell.j0, box.j1 - cell.j0 };
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

void Casting::castPlainly(
  const BinPage& page, const CellGrid::Level& level, CellRays& rays) const
{
  for (int k = 0; k < page.count; ++k)
  {
    const BinEntry& entry = page.entries[k];
    const Window box = this->boxIn(rays, level, entry);
    if (!box.empty())
    {
      this->test(this->triangle(entry.triangle), entry.triangle, box, rays);
    }
  }
}

void Casting::test(
  const Triangle& t, std::uint32_t number, const Window& box, CellRays& rays) const
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

void Casting::cast(const BinPage& page, const CellGrid::Level& level, CellRays& rays,
  CastBatches& batches) const
{
  const bool isFinest = this->Grid.isFinest(level);
  for (int k = 0; k < page.count; ++k)
  {
    const BinEntry& entry = page.entries[k];
    const Window box = this->boxIn(rays, level, entry);
    if (box.empty() ||
      (!isFinest && this->misses(this->triangle(entry.triangle), rays, box)))
    {
      continue;
    }
    const Material& material = this->Triangles.partOf(entry.triangle).surface->material;
    const bool isSmall = isFinest && box.width() <= 2 && box.height() <= 2 &&
      !material.cullFront && !material.cullBack;
    const int shape = 2 * (box.height() - 1) + (box.width() - 1);
    CastBatch& batch = isSmall ? batches.small[shape] : batches.large;
    batch.triangles[batch.count] = entry.triangle;
    batch.boxes[batch.count] = box;
    batch.isBoxExact[batch.count] = isFinest;
    batch.cullFront[batch.count] = material.cullFront;
    batch.cullBack[batch.count] = material.cullBack;
    ++batch.count;
    if (batch.isFull())
    {
      isSmall ? this->flushSmall(shape, rays, batches) : this->flushLarge(rays, batch);
    }
  }
}

void Casting::flush(CellRays& rays, CastBatches& batches) const
{
  for (int shape = 0; shape < 4; ++shape)
  {
    this->flushSmall(shape, rays, batches);
  }
  this->flushLarge(rays, batches.large);
}

void Casting::flushSmall(int shape, CellRays& rays, CastBatches& batches) const
{
  CastBatch& batch = batches.small[shape];
  this->load(batch);
  castSmall(this->Frame, batch, shape % 2 + 1, shape / 2 + 1, rays);
  batch.count = 0;
}

void Casting::flushLarge(CellRays& rays, CastBatch& batch) const
{
  this->load(batch);
  castLarge(this->Frame, batch, rays);
  batch.count = 0;
}

// Points lie anywhere in memory: first ask for all of them, then read them.
void Casting::load(CastBatch& batch) const
{
  std::uint64_t corners[CastBatch::capacity][3];
  const Surface* surfaces[CastBatch::capacity];
  for (int k = 0; k < batch.count; ++k)
  {
    const Mesh::Part& part = this->Triangles.partOf(batch.triangles[k]);
    const std::size_t first = 3 * (batch.triangles[k] - part.firstTriangle);
    surfaces[k] = part.surface;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      corners[k][corner] = part.surface->corners[first + corner];
      hwy::Prefetch(part.surface->points.at(corners[k][corner]));
    }
  }
  for (int k = 0; k < batch.count; ++k)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const Vec3 p = surfaces[k]->points[corners[k][corner]];
      batch.points[3 * corner][k] = p.x;
      batch.points[3 * corner + 1][k] = p.y;
      batch.points[3 * corner + 2][k] = p.z;
    }
  }
}
}
