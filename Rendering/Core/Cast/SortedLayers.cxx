// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SortedLayers.h"

#include <algorithm>
#include <cmath>

namespace lambent
{
namespace
{
/// Sorts the hits of one sample.
class Order
{
public:
  Order(const FrameMesh& mesh, const TileSamples& samples)
    : Mesh(mesh)
    , Samples(samples)
  {
  }

  /// Sorts by the near ends of the ranges first. Then groups whose ranges overlap are sorted by
  /// depth. Once a near end lies behind a group, so do all that follow, however long their ranges.
  void sort(Layer* begin, Layer* end) const
  {
    constexpr std::ptrdiff_t few = 16;
    const auto isNearer = [](const Layer& a, const Layer& b) { return a.high > b.high; };
    end - begin > few ? std::sort(begin, end, isNearer) : insert(begin, end, isNearer);
    for (Layer *group = begin, *next = begin; group < end; group = next)
    {
      float low = group->low;
      for (++next; next < end && !(next->high < low); ++next)
      {
        low = std::min(low, next->low);
      }
      if (next - group > 1)
      {
        this->sortByDepth(group, next);
      }
    }
  }

private:
  /// Sorts by insertion, which is the fastest for the few hits that samples have as a rule.
  template <typename IsBefore>
  static void insert(Layer* begin, Layer* end, const IsBefore& isBefore)
  {
    for (Layer* next = begin + 1; next < end; ++next)
    {
      const Layer layer = *next;
      Layer* place = next;
      for (; place > begin && isBefore(layer, place[-1]); --place)
      {
        *place = place[-1];
      }
      *place = layer;
    }
  }

  void sortByDepth(Layer* begin, Layer* end) const
  {
    for (Layer* layer = begin; layer < end; ++layer)
    {
      if (std::isnan(layer->depth))
      {
        layer->depth = depthIn(this->Mesh, this->Samples)(layer->primitive, layer->sample);
      }
    }
    std::sort(begin, end,
      [](const Layer& a, const Layer& b)
      { return a.depth < b.depth || (a.depth == b.depth && a.primitive < b.primitive); });
  }

  const FrameMesh& Mesh;
  const TileSamples& Samples;
};

/// The edge or corner of a triangle that a ray hits exactly. A corner has the same point twice.
struct Outline
{
  FramePoint p, q;

  static bool isSame(const FramePoint& a, const FramePoint& b)
  {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }
  bool operator==(const Outline& other) const
  {
    return (isSame(this->p, other.p) && isSame(this->q, other.q)) ||
      (isSame(this->p, other.q) && isSame(this->q, other.p));
  }
};

/// Removes hits that lie on the same edge or corner as a hit before.
class Repeats
{
public:
  Repeats(const FrameMesh& mesh, const TileSamples& samples)
    : Mesh(mesh)
    , Samples(samples)
  {
  }

  /// Removes them from the sorted hits of a sample. Returns the number of those that are left.
  std::uint32_t removeFrom(Layer* begin, std::uint32_t count)
  {
    this->Outlines.clear();
    Layer* const end = std::remove_if(
      begin, begin + count, [this](const Layer& layer) { return this->isRepeated(layer); });
    return static_cast<std::uint32_t>(end - begin);
  }

private:
  bool isRepeated(const Layer& layer)
  {
    if (std::isnan(layer.depth))
    {
      return false;
    }
    const SceneMesh::Part& part = this->Mesh.mesh().partOf(layer.primitive);
    if (!part.isTransparent() || part.kind() != PrimitiveKind::Triangle)
    {
      return false;
    }
    const FrameTriangle triangle = this->Mesh.triangle(part, layer.primitive);
    Hit hit{};
    triangle.isHit(this->Samples.x(layer.sample), this->Samples.y(layer.sample), hit);
    if (hit.e0 != 0.0 && hit.e1 != 0.0 && hit.e2 != 0.0)
    {
      return false;
    }
    const Outline outline = outlineAt(triangle, hit);
    const bool isRepeated =
      std::find(this->Outlines.begin(), this->Outlines.end(), outline) != this->Outlines.end();
    this->Outlines.push_back(outline);
    return isRepeated;
  }

  static Outline outlineAt(const FrameTriangle& t, const Hit& hit)
  {
    const FramePoint& onB = hit.e1 == 0.0 ? t.c : t.b; // of edge bc; c if edge ca is hit as well
    const FramePoint& onC = hit.e2 == 0.0 ? t.b : t.c;
    return hit.e0 == 0.0 ? Outline{ onB, onC }
      : hit.e1 == 0.0    ? Outline{ hit.e2 == 0.0 ? t.a : t.c, t.a }
                         : Outline{ t.a, t.b };
  }

  const FrameMesh& Mesh;
  const TileSamples& Samples;
  std::vector<Outline> Outlines; ///< of hits of the sample
};
}

/// Sets Firsts.
void SortedLayers::countOf(const TileHits<Nearest>& opaque, const Layers& layers)
{
  const std::size_t samples = opaque.samples.size();
  const std::uint32_t* const primitives = opaque.hits.primitives();
  this->Firsts.assign(samples + 1, 0);
  for (std::size_t sample = 0; sample < samples; ++sample)
  {
    this->Firsts[sample + 1] = primitives[sample] != noPrimitive ? 1 : 0;
  }
  for (const Layer& layer : layers.hits())
  {
    ++this->Firsts[layer.sample + 1];
  }
  for (std::size_t sample = 0; sample < samples; ++sample)
  {
    this->Firsts[sample + 1] += this->Firsts[sample];
  }
}

void SortedLayers::sort(
  const FrameMesh& mesh, const TileHits<Nearest>& opaque, const Layers& layers)
{
  const std::size_t samples = opaque.samples.size();
  const Nearest& nearest = opaque.hits;
  this->countOf(opaque, layers);
  this->Sorted.resize(this->Firsts[samples]);
  this->Primitives.resize(this->Firsts[samples]);
  for (std::size_t sample = 0; sample < samples; ++sample)
  {
    if (nearest.primitives()[sample] != noPrimitive)
    {
      this->place({ nearest.lows()[sample], nearest.highs()[sample],
        static_cast<std::uint32_t>(sample), nearest.primitives()[sample], nearest.depth(sample) });
    }
  }
  for (const Layer& layer : layers.hits())
  {
    this->place(layer);
  }
  // Each first is now the next sample's.
  std::copy_backward(this->Firsts.begin(), this->Firsts.end() - 1, this->Firsts.end());
  this->Firsts[0] = 0;
  this->Counts.assign(samples, 0);
  const Order order(mesh, opaque.samples);
  Repeats repeats(mesh, opaque.samples);
  for (std::size_t sample = 0; sample < samples; ++sample)
  {
    Layer* const begin = this->Sorted.data() + this->Firsts[sample];
    std::uint32_t count = this->Firsts[sample + 1] - this->Firsts[sample];
    if (count > 1)
    {
      order.sort(begin, begin + count);
      count = repeats.removeFrom(begin, count);
    }
    this->Counts[sample] = count;
    for (std::uint32_t k = 0; k < count; ++k)
    {
      this->Primitives[this->Firsts[sample] + k] = begin[k].primitive;
    }
  }
}
}
