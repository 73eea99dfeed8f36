// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting.h"

#include "CastingKernel.h"

#include <hwy/cache_control.h>

#include <algorithm>

namespace lambent
{
namespace
{
/// A range that overlaps all others, so that the depth decides.
constexpr Nearness anyNearness{ -std::numeric_limits<float>::infinity(),
  std::numeric_limits<float>::infinity() };

/// If the boxes of the waiting triangles have more than the area of this many tiles, the nearest
/// triangles are cast first.
constexpr std::int64_t manyLayers = 16;

/// The end of a bin's step, at most `most`, in samples. The bin begins at `begin`, at most 0. The
/// last sample of a step fits an int, its end may not.
int endOf(int begin, int step, int unit, int most)
{
  const int last = begin + ((step << unit) + ((1 << unit) - 1));
  return std::min(last, most - 1) + 1;
}

/// Returns a function that computes the depth of a triangle at a sample of a tile.
auto depthIn(const FrameMesh& mesh, const TileSamples& samples)
{
  return [&mesh, &samples](std::uint32_t triangle, std::size_t sample)
  {
    double depth;
    mesh.hits(triangle, samples.x(sample), samples.y(sample), depth);
    return depth;
  };
}
}

template <typename Policy>
Window Casting<Policy>::boxIn(
  const TileSamples& samples, const TileGrid::Level& level, const BinEntry& entry) const
{
  const Window& tile = samples.window();
  const Window bin = this->Grid.window(level, tile.i0, tile.j0);
  // Relative to the tile, so that no sum exceeds an int.
  const int i = bin.i0 - tile.i0, j = bin.j0 - tile.j0, unit = level.unitShift;
  return { std::max(i + (entry.i0 << unit), 0), endOf(i, entry.i1, unit, tile.width()),
    std::max(j + (entry.j0 << unit), 0), endOf(j, entry.j1, unit, tile.height()) };
}

template <typename Policy>
void Casting<Policy>::castPlainly(
  const BinEntry* entries, int count, const TileGrid::Level& level, TileHits<Policy>& tile) const
{
  for (int k = 0; k < count; ++k)
  {
    const BinEntry& entry = entries[k];
    const Window box = this->boxIn(tile.samples, level, entry);
    if (!box.empty())
    {
      this->test(this->Mesh.triangle(entry.triangle), entry.triangle, box, tile);
    }
  }
}

template <typename Policy>
void Casting<Policy>::test(
  const FrameTriangle& t, std::uint32_t number, const Window& box, TileHits<Policy>& tile) const
{
  const TileSamples& samples = tile.samples;
  for (int j = box.j0; j < box.j1; ++j)
  {
    for (int i = box.i0; i < box.i1; ++i)
    {
      Hit hit;
      if (t.isHit(samples.xs()[i], samples.ys()[j], hit))
      {
        tile.hits.offer(static_cast<std::size_t>(j) * samples.stride() + i, number, anyNearness,
          hit.depth, depthIn(this->Mesh, samples));
      }
    }
  }
}

template <typename Policy>
void Casting<Policy>::cast(const BinEntry* entries, int count, const TileGrid::Level& level,
  TileHits<Policy>& tile, CastBatch& batch) const
{
  const Window& window = tile.samples.window();
  const Window bin = this->Grid.window(level, window.i0, window.j0);
  const int i = bin.i0 - window.i0, j = bin.j0 - window.j0, unit = level.unitShift;
  const int width = window.width(), height = window.height();
  for (int k = 0; k < count; ++k)
  {
    const BinEntry& entry = entries[k];
    const Window box = { std::max(i + (entry.i0 << unit), 0), endOf(i, entry.i1, unit, width),
      std::max(j + (entry.j0 << unit), 0), endOf(j, entry.j1, unit, height) };
    if (box.empty() || entry.nearest < batch.least)
    {
      continue;
    }
    batch.waiting[batch.waitingCount++] = { entry.triangle, entry.nearest, box };
    batch.waitingArea += static_cast<std::int64_t>(box.width()) * box.height();
    if (batch.waitingCount == CastBatch::mostWaiting)
    {
      this->castWaiting(tile, batch);
    }
  }
}

/// Casts all waiting triangles. If they may cover the tile many times, casts the nearest first, so
/// that triangles behind them can be dropped without reading their points.
template <typename Policy>
void Casting<Policy>::castWaiting(TileHits<Policy>& tile, CastBatch& batch) const
{
  const Window& window = tile.samples.window();
  int begin = 0;
  if (batch.waitingCount > 4 * CastBatch::capacity &&
    batch.waitingArea > manyLayers * window.width() * window.height())
  {
    begin = CastBatch::capacity;
    std::nth_element(batch.waiting, batch.waiting + begin, batch.waiting + batch.waitingCount,
      [](const WaitingTriangle& a, const WaitingTriangle& b) { return a.nearest > b.nearest; });
    this->castWaiting(0, begin, tile, batch);
    this->castBatch(tile, batch); // also finds batch.least
  }
  this->castWaiting(begin, batch.waitingCount, tile, batch);
  batch.waitingCount = 0;
  batch.waitingArea = 0;
}

/// Casts some of the waiting triangles. The last of them may remain in the batch.
template <typename Policy>
void Casting<Policy>::castWaiting(
  int begin, int end, TileHits<Policy>& tile, CastBatch& batch) const
{
  constexpr int atOnce = 32;
  const WaitingTriangle* triangles[atOnce];
  Candidate candidates[atOnce];
  while (begin < end)
  {
    int count = 0;
    for (; begin < end && count < atOnce; ++begin)
    {
      triangles[count] = &batch.waiting[begin];
      count += !(triangles[count]->nearest < batch.least);
    }
    this->fetch(triangles, count, candidates);
    for (int k = 0; k < count; ++k)
    {
      this->add(triangles[k]->number, candidates[k], triangles[k]->box, tile, batch);
    }
  }
}

// Points are scattered in memory, so many are prefetched before the first is read.
template <typename Policy>
void Casting<Policy>::fetch(
  const WaitingTriangle* const* triangles, int count, Candidate* candidates) const
{
  for (int k = 0; k < count; ++k)
  {
    const std::uint32_t number = triangles[k]->number;
    const SceneMesh::Part& part = this->Mesh.mesh().partOf(number);
    candidates[k].part = &part;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      candidates[k].corners[corner] = part.corners()[3 * (number - part.firstTriangle) + corner];
      hwy::Prefetch(part.points().at(candidates[k].corners[corner]));
    }
  }
}

template <typename Policy>
void Casting<Policy>::add(std::uint32_t number, const Candidate& candidate, const Window& box,
  TileHits<Policy>& tile, CastBatch& batch) const
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
    this->castBatch(tile, batch);
  }
}

template <typename Policy>
void Casting<Policy>::flush(TileHits<Policy>& tile, CastBatch& batch) const
{
  this->castWaiting(tile, batch);
  this->castBatch(tile, batch);
  batch.least = -std::numeric_limits<float>::infinity();
}

template <typename Policy>
void Casting<Policy>::castBatch(TileHits<Policy>& tile, CastBatch& batch) const
{
  lambent::castBatch(this->Frame, tile.samples, tile.hits, batch);
  for (const ExactHit& hit : batch.hits)
  {
    tile.hits.offer(hit.sample, hit.triangle, nearnessOf(hit.depth, this->Frame.parallel),
      hit.depth, depthIn(this->Mesh, tile.samples));
  }
  batch.count = 0;
  batch.hits.clear();
}

template <typename Policy>
void Casting<Policy>::addHits(const Fragment* hits, int count, TileHits<Policy>& tile) const
{
  for (int k = 0; k < count; ++k)
  {
    tile.hits.offer(
      hits[k].sample, hits[k].triangle, hits[k].nearness, depthIn(this->Mesh, tile.samples));
  }
}

template <typename Policy>
void Casting<Policy>::merge(const TileHits<Policy>& from, TileHits<Policy>& tile) const
{
  tile.hits.merge(from.hits, this->Frame.parallel, depthIn(this->Mesh, tile.samples));
}

template class Casting<Nearest>;
}
