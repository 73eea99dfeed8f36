// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "CastingKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "CastingSetup.h"
#include "ExactRow.h"
#include "VectorLayers.h"
#include "VectorNearest.h"

#include "CastingKernel.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
Floats smallest(Floats a, Floats b, Floats c)
{
  return hn::Min(hn::Min(a, b), c);
}

Floats largest(Floats a, Floats b, Floats c)
{
  return hn::Max(hn::Max(a, b), c);
}

/// An affine function of the sample, for several columns: a value that all rows share, and the
/// change per row.
struct Column
{
  Floats constant, perRow;

  Column(const AffineFloats& numbers, int lane, Floats i)
    : constant(hn::Add(
        hn::Set(f, numbers.constant[lane]), hn::Mul(hn::Set(f, numbers.perColumn[lane]), i)))
    , perRow(hn::Set(f, numbers.perRow[lane]))
  {
  }

  Floats at(Floats j) const { return hn::Add(this->constant, hn::Mul(this->perRow, j)); }
};

/// Casts several columns of a triangle's box, from the sample i on.
template <typename VectorPolicy>
void castColumns(const Triangles& all, int lane, const BoxTriangle& t, int i,
  const TileSamples& samples, const VectorPolicy& policy, std::vector<ExactHit>& hits)
{
  const Floats columns = hn::Add(hn::Iota(f, 0.0f), hn::Set(f, static_cast<float>(i)));
  const FloatMask inside = columnsBefore(columns, t.box.i1);
  const Column edges[3] = { { all.edges[0], lane, columns }, { all.edges[1], lane, columns },
    { all.edges[2], lane, columns } };
  const Column nearness(all.nearness, lane, columns);
  const Floats error = hn::Set(f, all.error[lane]), minusError = hn::Neg(error);
  const Floats spread = hn::Set(f, all.spread[lane]);
  const Floats farthest = hn::Set(f, all.farthest[lane]), nearest = hn::Set(f, all.nearest[lane]);
  const FloatMask never = hn::Lt(columns, hn::Zero(f));
  for (int row = t.box.j0; row < t.box.j1; ++row)
  {
    const Floats j = hn::Set(f, static_cast<float>(row));
    const Floats e0 = edges[0].at(j), e1 = edges[1].at(j), e2 = edges[2].at(j);
    const Floats low = smallest(e0, e1, e2), high = largest(e0, e1, e2);
    const FloatMask front = hn::Gt(low, error), back = hn::Lt(high, minusError);
    const FloatMask miss = hn::And(hn::Lt(low, minusError), hn::Gt(high, error));
    const FloatMask hit =
      hn::And(inside, hn::Or(t.cullFront ? never : front, t.cullBack ? never : back));
    FloatMask open = hn::AndNot(hn::Or(miss, hn::Or(front, back)), inside);
    if (hn::AllFalse(f, hn::Or(hit, open)))
    {
      continue;
    }
    const std::size_t sample = static_cast<std::size_t>(row) * samples.stride() + i;
    const Floats value = nearness.at(j);
    const Floats from = hn::Max(hn::Sub(value, spread), farthest);
    const Floats to = hn::Min(hn::Add(value, spread), nearest);
    open = hn::Or(open, policy.keep(f, sample, hit, from, to, t.number));
    if (!hn::AllFalse(f, open))
    {
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(f, open, bits);
      exactRow(t, row, i, bits, samples, hits);
    }
  }
}

/// Casts the whole box exactly.
void castExactly(const BoxTriangle& t, const TileSamples& samples, std::vector<ExactHit>& hits)
{
  for (int i = t.box.i0; i < t.box.i1; i += step)
  {
    const Floats columns = hn::Add(hn::Iota(f, 0.0f), hn::Set(f, static_cast<float>(i)));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(f, columnsBefore(columns, t.box.i1), bits);
    for (int row = t.box.j0; row < t.box.j1; ++row)
    {
      exactRow(t, row, i, bits, samples, hits);
    }
  }
}

template <typename VectorPolicy>
float castTriangles(const CameraFrame& frame, const TileSamples& samples,
  const VectorPolicy& policy, TriangleBatch& batch)
{
  const Window& window = samples.window();
  const TilePlane tile(frame, samples);
  const float leastBefore = policy.least(samples);
  float least = leastBefore;
  HWY_ALIGN Triangles all;
  for (int k = 0; k < batch.count; k += static_cast<int>(lanes))
  {
    setUp(frame, tile, batch, k, all);
    for (int lane = 0; lane < std::min(static_cast<int>(lanes), batch.count - k); ++lane)
    {
      if (all.isMissed(lane))
      {
        continue;
      }
      const BoxTriangle t(all, lane, batch, k + lane);
      if (!all.isRegular(lane))
      {
        castExactly(t, samples, batch.hits);
        continue;
      }
      if (all.nearestInBox[lane] < least)
      {
        continue;
      }
      for (int i = t.box.i0; i < t.box.i1; i += step)
      {
        castColumns(all, lane, t, i, samples, policy, batch.hits);
      }
      if (2 * t.box.width() * t.box.height() > window.width() * window.height())
      {
        least = policy.least(samples); // the triangle may have covered the tile
      }
    }
  }
  return leastBefore;
}

float CastNearest(
  const CameraFrame& frame, const TileSamples& samples, Nearest& nearest, TriangleBatch& batch)
{
  return castTriangles(frame, samples, VectorNearest(nearest), batch);
}

float CastLayers(
  const CameraFrame& frame, const TileSamples& samples, Layers& layers, TriangleBatch& batch)
{
  return castTriangles(frame, samples, VectorLayers(layers, samples), batch);
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(CastNearest);
HWY_EXPORT(CastLayers);

float castBatch(
  const CameraFrame& frame, const TileSamples& samples, Nearest& nearest, TriangleBatch& batch)
{
  return HWY_DYNAMIC_DISPATCH(CastNearest)(frame, samples, nearest, batch);
}

float castBatch(
  const CameraFrame& frame, const TileSamples& samples, Layers& layers, TriangleBatch& batch)
{
  return HWY_DYNAMIC_DISPATCH(CastLayers)(frame, samples, layers, batch);
}
}
#endif
