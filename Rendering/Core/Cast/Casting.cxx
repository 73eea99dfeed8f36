// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting.h"

#include "CastingKernel.h"

#include <hwy/cache_control.h>

namespace lambent
{
namespace
{
constexpr float infinity = std::numeric_limits<float>::infinity();
}

Window Casting::boxIn(
  const TileSamples& rays, const TileGrid::Level& level, const BinEntry& entry) const
{
  const Window& tile = rays.window();
  const Window bin = this->Grid.window(level, tile.i0, tile.j0);
  const int unit = level.unitShift;
  const Window box =
    intersection({ bin.i0 + (entry.i0 << unit), bin.i0 + ((entry.i1 + 1) << unit),
                   bin.j0 + (entry.j0 << unit), bin.j0 + ((entry.j1 + 1) << unit) },
      tile);
  return { box.i0 - tile.i0, box.i1 - tile.i0, box.j0 - tile.j0, box.j1 - tile.j0 };
}

void Casting::castPlainly(
  const BinEntry* entries, int count, const TileGrid::Level& level, TileSamples& rays) const
{
  for (int k = 0; k < count; ++k)
  {
    const BinEntry& entry = entries[k];
    const Window box = this->boxIn(rays, level, entry);
    if (!box.empty())
    {
      this->test(this->Mesh.triangle(entry.triangle), entry.triangle, box, rays);
    }
  }
}

void Casting::test(
  const FrameTriangle& t, std::uint32_t number, const Window& box, TileSamples& rays) const
{
  for (int j = box.j0; j < box.j1; ++j)
  {
    for (int i = box.i0; i < box.i1; ++i)
    {
      Hit hit;
      if (t.isHit(rays.xs()[i], rays.ys()[j], hit))
      {
        // No range tells anything here: depths alone decide.
        rays.offer(static_cast<std::size_t>(j) * rays.stride() + i, hit.depth, number,
          { -infinity, infinity });
      }
    }
  }
}

void Casting::cast(const BinEntry* entries, int count, const TileGrid::Level& level,
  TileSamples& rays, CastBatch& batch) const
{
  constexpr int atOnce = 32;
  Candidate candidates[atOnce];
  for (int first = 0; first < count; first += atOnce)
  {
    const int end = std::min(first + atOnce, count);
    this->fetch(entries + first, end - first, candidates);
    for (int k = first; k < end; ++k)
    {
      const Window box = this->boxIn(rays, level, entries[k]);
      if (!box.empty())
      {
        this->add(entries[k].triangle, candidates[k - first], box, rays, batch);
      }
    }
  }
}

// Points lie anywhere in memory: many are asked for before the first is read.
void Casting::fetch(const BinEntry* entries, int count, Candidate* candidates) const
{
  for (int k = 0; k < count; ++k)
  {
    const std::uint32_t number = entries[k].triangle;
    const SceneMesh::Part& part = this->Mesh.mesh().partOf(number);
    candidates[k].part = &part;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      candidates[k].corners[corner] = part.corners()[3 * (number - part.firstTriangle) + corner];
      hwy::Prefetch(part.points().at(candidates[k].corners[corner]));
    }
  }
}

void Casting::add(std::uint32_t number, const Candidate& candidate, const Window& box,
  TileSamples& rays, CastBatch& batch) const
{
  for (int corner = 0; corner < 3; ++corner)
  {
    const Vec3 p = candidate.part->points()[candidate.corners[corner]];
    batch.points[3 * corner][batch.count] = p.x;
    batch.points[3 * corner + 1][batch.count] = p.y;
    batch.points[3 * corner + 2][batch.count] = p.z;
  }
  batch.triangles[batch.count] = number;
  batch.boxes[batch.count] = box;
  batch.cullFront[batch.count] = candidate.part->appearance->cullFront;
  batch.cullBack[batch.count] = candidate.part->appearance->cullBack;
  if (++batch.count == CastBatch::capacity)
  {
    this->flush(rays, batch);
  }
}

void Casting::flush(TileSamples& rays, CastBatch& batch) const
{
  castBatch(this->Frame, batch, rays);
  for (const ExactHit& hit : batch.hits)
  {
    this->offer(hit.ray, hit.depth, hit.triangle, rays);
  }
  batch.count = 0;
  batch.hits.clear();
}

double Casting::depthAt(std::uint32_t triangle, const TileSamples& rays, std::size_t ray) const
{
  double depth;
  this->Mesh.hits(triangle, rays.x(ray), rays.y(ray), depth);
  return depth;
}

void Casting::findDepth(std::size_t ray, TileSamples& rays) const
{
  if (!rays.knowsDepth(ray))
  {
    rays.setDepth(ray, this->depthAt(rays.triangles()[ray], rays, ray));
  }
}

/// A hit that is certain.
void Casting::offer(const Fragment& hit, TileSamples& rays) const
{
  if (hit.nearness.low > rays.highs()[hit.ray])
  {
    rays.set(hit.ray, hit.triangle, hit.nearness);
  }
  else if (!(hit.nearness.high < rays.lows()[hit.ray]))
  {
    this->findDepth(hit.ray, rays);
    rays.offer(hit.ray, this->depthAt(hit.triangle, rays, hit.ray), hit.triangle, hit.nearness);
  }
}

/// A hit of known depth.
void Casting::offer(std::size_t ray, double depth, std::uint32_t triangle, TileSamples& rays) const
{
  const Nearness range = nearnessOf(depth, this->Frame.parallel);
  if (!(range.high < rays.lows()[ray]))
  {
    this->findDepth(ray, rays);
    rays.offer(ray, depth, triangle, range);
  }
}

void Casting::addHits(const Fragment* hits, int count, TileSamples& rays) const
{
  for (int k = 0; k < count; ++k)
  {
    this->offer(hits[k], rays);
  }
}

void Casting::merge(const TileSamples& from, TileSamples& rays) const
{
  for (std::size_t ray = 0; ray < rays.size(); ++ray)
  {
    if (from.triangles()[ray] == noTriangle)
    {
      continue;
    }
    if (from.knowsDepth(ray))
    {
      this->offer(ray, from.depth(ray), from.triangles()[ray], rays);
    }
    else
    {
      this->offer({ from.triangles()[ray], static_cast<std::uint32_t>(ray),
                    { from.lows()[ray], from.highs()[ray] } },
        rays);
    }
  }
}
}
