// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Casting.h"

#include <algorithm>

namespace lambent
{
namespace
{
/// A range that overlaps all others, so that the depth decides.
constexpr Nearness anyNearness{ -std::numeric_limits<float>::infinity(),
  std::numeric_limits<float>::infinity() };

/// If the boxes of the waiting primitives have more than the area of this many tiles, the nearest
/// ones are cast first: so many that they fill a batch.
constexpr std::int64_t manyLayers = 16;
constexpr int nearestCount = TriangleBatch::capacity;

/// The boxes of a bin's entries, in samples from the first of a tile.
class EntryBoxes
{
public:
  EntryBoxes(const TileGrid& grid, const TileGrid::Level& level, const Window& tile)
    : Unit(level.unitShift)
    , Width(tile.width())
    , Height(tile.height())
  {
    const Window bin = grid.window(level, tile.i0, tile.j0);
    this->I = bin.i0 - tile.i0;
    this->J = bin.j0 - tile.j0;
  }

  /// Clipped to the tile.
  Window of(const BinEntry& entry) const
  {
    return { std::max(this->I + (entry.i0 << this->Unit), 0),
      this->endOf(this->I, entry.i1, this->Width), std::max(this->J + (entry.j0 << this->Unit), 0),
      this->endOf(this->J, entry.j1, this->Height) };
  }

private:
  /// The last sample of a step fits an int, but the end after it may not.
  int endOf(int begin, int step, int most) const
  {
    const int last = begin + ((step << this->Unit) + ((1 << this->Unit) - 1));
    return std::min(last, most - 1) + 1;
  }

  int I, J; ///< the first sample of the bin, at most 0
  const int Unit, Width, Height;
};
}

template <typename Policy>
void Casting<Policy>::castPlainly(
  const BinEntry* entries, int count, const TileGrid::Level& level, TileHits<Policy>& tile) const
{
  const EntryBoxes boxes(this->Grid, level, tile.samples.window());
  for (int k = 0; k < count; ++k)
  {
    const BinEntry& entry = entries[k];
    const Window box = boxes.of(entry);
    if (!box.empty() && this->takes(entry.primitive))
    {
      this->Mesh.visit(entry.primitive,
        [&](const auto& primitive) { this->test(primitive, entry.primitive, box, tile); });
    }
  }
}

template <typename Policy>
template <typename Primitive>
void Casting<Policy>::test(
  const Primitive& primitive, std::uint32_t number, const Window& box, TileHits<Policy>& tile) const
{
  const TileSamples& samples = tile.samples;
  for (int j = box.j0; j < box.j1; ++j)
  {
    for (int i = box.i0; i < box.i1; ++i)
    {
      double depth;
      if (primitive.isHit(samples.xs()[i], samples.ys()[j], depth))
      {
        tile.hits.offer(static_cast<std::size_t>(j) * samples.stride() + i, number, anyNearness,
          depth, depthIn(this->Mesh, samples));
      }
    }
  }
}

template <typename Policy>
void Casting<Policy>::cast(const BinEntry* entries, int count, const TileGrid::Level& level,
  TileHits<Policy>& tile, CastingMemory& memory) const
{
  const EntryBoxes boxes(this->Grid, level, tile.samples.window());
  WaitingPrimitives& waiting = memory.waiting;
  for (int k = 0; k < count; ++k)
  {
    const BinEntry& entry = entries[k];
    const Window box = boxes.of(entry);
    if (box.empty() || entry.nearest < tile.least)
    {
      continue;
    }
    waiting.items[waiting.count++] = { entry.primitive, entry.nearest, box };
    waiting.area += static_cast<std::int64_t>(box.width()) * box.height();
    if (waiting.count == WaitingPrimitives::capacity)
    {
      this->castWaiting(tile, memory);
    }
  }
}

/// Casts all waiting primitives. If they may cover the tile many times, casts the nearest first, so
/// that those behind them can be dropped without reading their points.
template <typename Policy>
void Casting<Policy>::castWaiting(TileHits<Policy>& tile, CastingMemory& memory) const
{
  const Window& window = tile.samples.window();
  WaitingPrimitives& waiting = memory.waiting;
  int begin = 0;
  if (waiting.count > 4 * nearestCount &&
    waiting.area > manyLayers * window.width() * window.height())
  {
    begin = nearestCount;
    std::nth_element(waiting.items, waiting.items + begin, waiting.items + waiting.count,
      [](const WaitingPrimitive& a, const WaitingPrimitive& b) { return a.nearest > b.nearest; });
    this->castWaiting(0, begin, tile, memory);
    this->flushBatches(tile, memory); // also finds tile.least
  }
  this->castWaiting(begin, waiting.count, tile, memory);
  waiting.count = 0;
  waiting.area = 0;
}

/// Casts some of the waiting primitives. The last ones may remain in their batches.
template <typename Policy>
void Casting<Policy>::castWaiting(
  int begin, int end, TileHits<Policy>& tile, CastingMemory& memory) const
{
  NextPrimitive next[TriangleCasting<Policy>::atOnce];
  while (begin < end)
  {
    int count = 0;
    for (; begin < end && count < TriangleCasting<Policy>::atOnce; ++begin)
    {
      next[count].waiting = &memory.waiting.items[begin];
      count += !(next[count].waiting->nearest < tile.least);
    }
    for (int k = 0; k < count; ++k)
    {
      next[k].part = &this->Mesh.mesh().partOf(next[k].waiting->number);
    }
    this->castNext(next, count, tile, memory);
  }
}

/// Casts primitives by their kinds.
template <typename Policy>
void Casting<Policy>::castNext(
  NextPrimitive* next, int count, TileHits<Policy>& tile, CastingMemory& memory) const
{
  if (this->IsMixed)
  {
    count =
      static_cast<int>(std::remove_if(next, next + count,
                         [this](const NextPrimitive& one) { return !this->takes(*one.part); }) -
        next);
  }
  int triangles = count;
  if (!this->Mesh.mesh().hasOnlyTriangles())
  {
    NextPrimitive* const end = next + count;
    const auto moveToFront = [end](NextPrimitive* begin, PrimitiveKind kind)
    {
      return std::partition(
        begin, end, [kind](const NextPrimitive& one) { return one.part->kind() == kind; });
    };
    NextPrimitive* const spheres = moveToFront(next, PrimitiveKind::Triangle);
    NextPrimitive* const lines = moveToFront(spheres, PrimitiveKind::Sphere);
    triangles = static_cast<int>(spheres - next);
    this->Spheres.cast(spheres, static_cast<int>(lines - spheres), tile, memory.spheres);
    this->Lines.cast(lines, static_cast<int>(end - lines), tile, memory.lineHits);
  }
  this->Triangles.cast(next, triangles, tile, memory.triangles);
}

template <typename Policy>
void Casting<Policy>::flushBatches(TileHits<Policy>& tile, CastingMemory& memory) const
{
  this->Triangles.flush(tile, memory.triangles);
  if (memory.spheres.count > 0)
  {
    this->Spheres.flush(tile, memory.spheres);
  }
}

template <typename Policy>
void Casting<Policy>::flush(TileHits<Policy>& tile, CastingMemory& memory) const
{
  this->castWaiting(tile, memory);
  this->flushBatches(tile, memory);
}

template <typename Policy>
void Casting<Policy>::addHits(const Fragment* hits, int count, TileHits<Policy>& tile) const
{
  const auto offer = [&](const Fragment& hit)
  { tile.hits.offer(hit.sample, hit.primitive, hit.nearness, depthIn(this->Mesh, tile.samples)); };
  if (!this->IsMixed)
  {
    std::for_each(hits, hits + count, offer);
    return;
  }
  for (int k = 0; k < count; ++k)
  {
    if (this->takes(hits[k].primitive))
    {
      offer(hits[k]);
    }
  }
}

template <typename Policy>
void Casting<Policy>::merge(const TileHits<Policy>& from, TileHits<Policy>& tile) const
{
  tile.hits.merge(from.hits, this->Frame.parallel, depthIn(this->Mesh, tile.samples));
}

template class Casting<Nearest>;
template class Casting<Layers>;
}
