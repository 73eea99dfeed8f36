// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "CoverageKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "Coverage.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
using V = hn::Vec<F>;
using M = hn::Mask<F>;
constexpr F f;
using U = hn::RebindToUnsigned<F>;
constexpr U u;
using I = hn::RebindToSigned<F>;
constexpr I s;

V smallest(V a, V b, V c)
{
  return hn::Min(hn::Min(a, b), c);
}

V largest(V a, V b, V c)
{
  return hn::Max(hn::Max(a, b), c);
}

/// One of the two products of the three edge functions.
struct Products
{
  V bc, ca, ab;
};

/// Some triangles of a batch.
struct Lanes
{
  V au, av, bu, bv, cu, cv;
  V error; ///< of their edge functions
  V near, far;
  M isUsed, isOversized;
};

Lanes load(const SmallTriangles& batch, int k, float d)
{
  const auto row = [&](int n) { return hn::Load(f, batch.points[n] + k); };
  Lanes t{ row(0), row(1), row(3), row(4), row(6), row(7), V(), V(), V(), M(), M() };
  const V width = hn::Sub(largest(t.au, t.bu, t.cu), smallest(t.au, t.bu, t.cu));
  const V height = hn::Sub(largest(t.av, t.bv, t.cv), smallest(t.av, t.bv, t.cv));
  const V extent = hn::Add(width, height);
  t.error = hn::Add(hn::Mul(hn::Set(f, 4.0f * d), hn::Add(extent, hn::Set(f, 2.0f * d))),
    hn::Mul(hn::Set(f, 1.0f / (1 << 20)), hn::Mul(width, height)));
  t.isOversized = hn::Not(hn::Lt(extent, hn::Set(f, 8.0f * SmallTriangles::side)));
  t.near = hn::Mul(smallest(row(2), row(5), row(8)), hn::Set(f, 1.0f - depthSlack));
  t.far = hn::Mul(largest(row(2), row(5), row(8)), hn::Set(f, 1.0f + depthSlack));
  t.isUsed = hn::RebindMask(f, hn::Lt(hn::Iota(s, k), hn::Set(s, batch.count)));
  return t;
}

/// (b_v - a_v) (p_u - a_u) of each edge, for the column p_u.
Products acrossColumn(const Lanes& t, V pu)
{
  return { hn::Mul(hn::Sub(t.cv, t.bv), hn::Sub(pu, t.bu)),
    hn::Mul(hn::Sub(t.av, t.cv), hn::Sub(pu, t.cu)),
    hn::Mul(hn::Sub(t.bv, t.av), hn::Sub(pu, t.au)) };
}

/// (b_u - a_u) (p_v - a_v) of each edge, for the row p_v.
Products acrossRow(const Lanes& t, V pv)
{
  return { hn::Mul(hn::Sub(t.cu, t.bu), hn::Sub(pv, t.bv)),
    hn::Mul(hn::Sub(t.au, t.cu), hn::Sub(pv, t.cv)),
    hn::Mul(hn::Sub(t.bu, t.au), hn::Sub(pv, t.av)) };
}

/// Rays, as many as there are lanes.
struct Rays
{
  hn::Vec<I> i, j;
};

void store(const Lanes& t, const Products& column, const Products& row, hn::Vec<U> triangles,
  const Rays& rays, const CellGrid& grid, CoveredRays& covered)
{
  const V bc = hn::Sub(row.bc, column.bc);
  const V ca = hn::Sub(row.ca, column.ca);
  const V ab = hn::Sub(row.ab, column.ab);
  const V low = smallest(bc, ca, ab), high = largest(bc, ca, ab);
  const V minusError = hn::Neg(t.error);
  const M isHit = hn::AndNot(t.isOversized, hn::Or(hn::Gt(low, t.error), hn::Lt(high, minusError)));
  const M isMiss =
    hn::AndNot(t.isOversized, hn::And(hn::Lt(low, minusError), hn::Gt(high, t.error)));
  const M hit = hn::And(isHit, t.isUsed);
  const M open = hn::AndNot(isMiss, hn::AndNot(isHit, t.isUsed)); // also what is no number
  if (hn::AllFalse(f, hn::Or(hit, open)))
  {
    return;
  }
  const CellGrid::Level& level = grid.levels().front();
  const auto inCell = hn::Set(s, (1 << level.shift) - 1);
  const auto cells = hn::Add(hn::Mul(hn::ShiftRightSame(rays.j, level.shift),
                               hn::Set(s, static_cast<std::int32_t>(level.columns))),
    hn::ShiftRightSame(rays.i, level.shift));
  const auto numbers =
    hn::Add(hn::ShiftLeftSame(hn::And(rays.j, inCell), grid.rayShift()), hn::And(rays.i, inCell));
  const auto hits = hn::RebindMask(s, hit);
  hn::CompressStore(triangles, hn::RebindMask(u, hit), u, covered.triangles + covered.certain);
  hn::CompressStore(cells, hits, s, covered.cells + covered.certain);
  hn::CompressStore(numbers, hits, s, covered.rays + covered.certain);
  hn::CompressStore(t.near, hit, f, covered.near + covered.certain);
  covered.certain +=
    static_cast<int>(hn::CompressStore(t.far, hit, f, covered.far + covered.certain));
  if (!hn::AllFalse(f, open))
  {
    const auto opens = hn::RebindMask(s, open);
    const auto places = hn::Add(hn::ShiftLeft<16>(rays.j), rays.i);
    const int at = covered.uncertain;
    hn::CompressStore(triangles, hn::RebindMask(u, open), u, covered.uncertainTriangles + at);
    hn::CompressStore(cells, opens, s, covered.uncertainCells + at);
    hn::CompressStore(numbers, opens, s, covered.uncertainRays + at);
    covered.uncertain +=
      static_cast<int>(hn::CompressStore(places, opens, s, covered.uncertainPlaces + at));
  }
}

void FindCoverage(const SmallTriangles& batch, int width, int height, float error,
  const CellGrid& grid, CoveredRays& covered)
{
  covered.certain = covered.uncertain = 0;
  for (int k = 0; k < batch.count; k += static_cast<int>(hn::Lanes(f)))
  {
    const Lanes t = load(batch, k, error);
    const auto triangles = hn::LoadU(u, batch.triangles + k);
    const Rays first{ hn::LoadU(s, batch.i + k), hn::LoadU(s, batch.j + k) };
    Products columns[SmallTriangles::side];
    for (int i = 0; i < width; ++i)
    {
      columns[i] =
        acrossColumn(t, hn::Add(hn::ConvertTo(f, first.i), hn::Set(f, static_cast<float>(i))));
    }
    for (int j = 0; j < height; ++j)
    {
      const Products row =
        acrossRow(t, hn::Add(hn::ConvertTo(f, first.j), hn::Set(f, static_cast<float>(j))));
      for (int i = 0; i < width; ++i)
      {
        const Rays rays{ hn::Add(first.i, hn::Set(s, i)), hn::Add(first.j, hn::Set(s, j)) };
        store(t, columns[i], row, triangles, rays, grid, covered);
      }
    }
  }
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(FindCoverage);

void findCoverage(const SmallTriangles& batch, int width, int height, float error,
  const CellGrid& grid, CoveredRays& covered)
{
  HWY_DYNAMIC_DISPATCH(FindCoverage)(batch, width, height, error, grid, covered);
}
}
#endif
