// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "CoverageKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "AppendLanes.h"
#include "VectorFrame.h"

#include "Coverage.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
using F = hn::CappedTag<float, 16>;
using Floats = hn::Vec<F>;
using FloatMask = hn::Mask<F>;
constexpr F f;
using U = hn::RebindToUnsigned<F>;
constexpr U u;
using I = hn::RebindToSigned<F>;
constexpr I s;

Floats smallest(Floats a, Floats b, Floats c)
{
  return hn::Min(hn::Min(a, b), c);
}

Floats largest(Floats a, Floats b, Floats c)
{
  return hn::Max(hn::Max(a, b), c);
}

/// The projected corners: au, av, depth of a, bu, ...
using Screen = float[9][SmallTriangles::capacity];

/// Projects the corners as PointLattice::locate() does, and rounds to float.
void project(const PointLattice& lattice, const CoverageBatch& batch, Screen& screen)
{
  const VectorFrame frame(lattice.frame());
  const hn::Rebind<float, D> df;
  for (int corner = 0; corner < 9; corner += 3)
  {
    for (int k = 0; k < batch.count; k += static_cast<int>(lanes))
    {
      const FrameVector p = frame.toFrame(hn::Load(d, batch.points[corner] + k),
        hn::Load(d, batch.points[corner + 1] + k), hn::Load(d, batch.points[corner + 2] + k));
      const V perUnit = hn::Div(hn::Set(d, lattice.samplesPerUnit()), p.w);
      const V column = hn::Add(hn::Mul(p.x, perUnit), hn::Set(d, lattice.columns().origin));
      const V row = hn::Add(hn::Mul(p.y, perUnit), hn::Set(d, lattice.rows().origin));
      hn::Store(hn::DemoteTo(df, column), df, screen[corner] + k);
      hn::Store(hn::DemoteTo(df, row), df, screen[corner + 1] + k);
      hn::Store(hn::DemoteTo(df, p.z), df, screen[corner + 2] + k);
    }
  }
}

/// One of the two products of each edge function.
struct Products
{
  Floats bc, ca, ab;
};

/// Triangles of a batch, one per lane.
struct Lanes
{
  Floats au, av, bu, bv, cu, cv;
  Floats error;     ///< of their edge functions
  Floats low, high; ///< nearness
  FloatMask isUsed;
};

Lanes load(const CoverageBatch& batch, const Screen& screen, int k, const PointLattice& lattice)
{
  const auto row = [&](int n) { return hn::Load(f, screen[n] + k); };
  Lanes t{ row(0), row(1), row(3), row(4), row(6), row(7), Floats(), Floats(), Floats(),
    FloatMask() };
  const Floats width = hn::Sub(largest(t.au, t.bu, t.cu), smallest(t.au, t.bu, t.cu));
  const Floats height = hn::Sub(largest(t.av, t.bv, t.cv), smallest(t.av, t.bv, t.cv));
  const Floats extent = hn::Add(width, height);
  const float moved = lattice.screenError();
  const Floats error =
    hn::Add(hn::Mul(hn::Set(f, 4.0f * moved), hn::Add(extent, hn::Set(f, 2.0f * moved))),
      hn::Mul(hn::Set(f, 1.0f / (1 << 20)), hn::Mul(width, height)));
  const Floats nearest = smallest(row(2), row(5), row(8));
  const Floats farthest = largest(row(2), row(5), row(8));
  const FloatMask isRanged =
    hn::And(hn::Gt(nearest, hn::Set(f, static_cast<float>(smallestRangedDepth))),
      hn::Lt(farthest, hn::Set(f, static_cast<float>(largestRangedDepth))));
  const FloatMask isSmall = hn::Lt(extent, hn::Set(f, 8.0f * SmallTriangles::side));
  t.error = hn::IfThenElse(
    hn::And(isRanged, isSmall), error, hn::Set(f, std::numeric_limits<float>::infinity()));
  const bool isParallel = lattice.frame().parallel;
  const Floats less = hn::Set(f, 1.0f - nearnessSlack), more = hn::Set(f, 1.0f + nearnessSlack);
  const Floats one = hn::Set(f, 1.0f);
  t.low = isParallel ? hn::Neg(hn::Mul(farthest, more)) : hn::Mul(hn::Div(one, farthest), less);
  t.high = isParallel ? hn::Neg(hn::Mul(nearest, less)) : hn::Mul(hn::Div(one, nearest), more);
  t.isUsed = hn::RebindMask(f, hn::Lt(hn::Iota(s, k), hn::Set(s, batch.count)));
  return t;
}

/// (b_v - a_v) (p_u - a_u) of each edge, for the column p_u.
Products acrossColumn(const Lanes& t, Floats pu)
{
  return { hn::Mul(hn::Sub(t.cv, t.bv), hn::Sub(pu, t.bu)),
    hn::Mul(hn::Sub(t.av, t.cv), hn::Sub(pu, t.cu)),
    hn::Mul(hn::Sub(t.bv, t.av), hn::Sub(pu, t.au)) };
}

/// (b_u - a_u) (p_v - a_v) of each edge, for the row p_v.
Products acrossRow(const Lanes& t, Floats pv)
{
  return { hn::Mul(hn::Sub(t.cu, t.bu), hn::Sub(pv, t.bv)),
    hn::Mul(hn::Sub(t.au, t.cu), hn::Sub(pv, t.cv)),
    hn::Mul(hn::Sub(t.bu, t.au), hn::Sub(pv, t.av)) };
}

/// Appends the samples that the mask selects.
int append(FloatMask mask, hn::Vec<U> samples, CoveredSample* out)
{
  static_assert(sizeof(CoveredSample) == sizeof(std::uint32_t), "a lane is a sample");
  return appendLanes(u, samples, hn::RebindMask(u, mask), reinterpret_cast<std::uint32_t*>(out));
}

void store(const Lanes& t, const Products& column, const Products& row, hn::Vec<U> samples,
  CoveredSamples& covered)
{
  const Floats bc = hn::Sub(row.bc, column.bc);
  const Floats ca = hn::Sub(row.ca, column.ca);
  const Floats ab = hn::Sub(row.ab, column.ab);
  const Floats low = smallest(bc, ca, ab), high = largest(bc, ca, ab);
  const Floats minusError = hn::Neg(t.error);
  const FloatMask isHit = hn::Or(hn::Gt(low, t.error), hn::Lt(high, minusError));
  const FloatMask isMiss = hn::And(hn::Lt(low, minusError), hn::Gt(high, t.error));
  const FloatMask hit = hn::And(isHit, t.isUsed);
  const FloatMask open = hn::AndNot(hn::Or(isMiss, isHit), t.isUsed); // includes NaN
  covered.certain += append(hit, samples, covered.certainSamples + covered.certain);
  if (HWY_UNLIKELY(!hn::AllFalse(f, open)))
  {
    covered.uncertain += append(open, samples, covered.uncertainSamples + covered.uncertain);
  }
}

void FindCoverage(const CoverageBatch& batch, const PointLattice& lattice, CoveredSamples& covered)
{
  covered.certain = covered.uncertain = 0;
  HWY_ALIGN Screen screen;
  project(lattice, batch, screen);
  for (int k = 0; k < batch.count; k += static_cast<int>(hn::Lanes(f)))
  {
    const Lanes t = load(batch, screen, k, lattice);
    hn::StoreU(t.low, f, covered.lows + k);
    hn::StoreU(t.high, f, covered.highs + k);
    const auto numbers = hn::Iota(u, k);
    const Floats firstColumn = hn::ConvertTo(f, hn::LoadU(s, batch.i + k));
    const Floats firstRow = hn::ConvertTo(f, hn::LoadU(s, batch.j + k));
    Floats bc[SmallTriangles::side], ca[SmallTriangles::side], ab[SmallTriangles::side];
    for (int i = 0; i < batch.width; ++i)
    {
      const Products column =
        acrossColumn(t, hn::Add(firstColumn, hn::Set(f, static_cast<float>(i))));
      bc[i] = column.bc;
      ca[i] = column.ca;
      ab[i] = column.ab;
    }
    for (int j = 0; j < batch.height; ++j)
    {
      const Products row = acrossRow(t, hn::Add(firstRow, hn::Set(f, static_cast<float>(j))));
      for (int i = 0; i < batch.width; ++i)
      {
        store(t, { bc[i], ca[i], ab[i] }, row,
          hn::Add(numbers, hn::Set(u, CoveredSample::at(i, j))), covered);
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

void findCoverage(const CoverageBatch& batch, const PointLattice& lattice, CoveredSamples& covered)
{
  HWY_DYNAMIC_DISPATCH(FindCoverage)(batch, lattice, covered);
}
}
#endif
