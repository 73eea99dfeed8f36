// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "LineCastingKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorDoubles.h"

#include "LineBounds.h"
#include "LineCastingKernel.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// The columns of a box, row by row, that a line may cover, and perhaps one more on each side.
class Columns
{
public:
  Columns(const LineBounds& bounds, const TileSamples& samples, double pixel, const Window& box)
    : Box(box)
    , PerRow(bounds.slope())
  {
    const double first = samples.xs()[0], perPixel = 1.0 / pixel;
    const double* const ys = samples.ys();
    const Interval x = bounds.inRow(ys[box.j0]);
    this->Low = (x.low - first) * perPixel - 1.0;
    this->High = (x.high - first) * perPixel + 2.0;
    const double across = std::fabs(x.low) + std::fabs(x.high) + std::fabs(first);
    const double up = std::fabs(ys[box.j0]) + std::fabs(ys[box.j1 - 1]);
    // Below it, rounding moves nothing by as much as a column.
    constexpr double largest = 1e12;
    this->AreBounded = (across + up * std::fabs(this->PerRow)) * perPixel < largest;
  }

  struct Range
  {
    int begin, end;
  };

  Range in(int row) const
  {
    if (!this->AreBounded)
    {
      return { this->Box.i0, this->Box.i1 };
    }
    const double moved = this->PerRow * (row - this->Box.j0);
    const double begin = std::max<double>(this->Low + moved, this->Box.i0);
    const double end = std::min<double>(this->High + moved, this->Box.i1);
    return { static_cast<int>(std::min<double>(begin, this->Box.i1)),
      static_cast<int>(std::max<double>(end, this->Box.i0)) };
  }

private:
  const Window& Box;
  double PerRow, Low, High; ///< in columns
  bool AreBounded;
};

/// intersectLine() for the rays through (x, y), one per lane.
template <bool IsParallel>
HWY_INLINE M intersectRays(const Line& line, V x, double y, M isWanted, V& depth)
{
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  const V dx = hn::Set(d, line.dx), dy = hn::Set(d, line.dy);
  const V perHalf = hn::Set(d, line.perHalf);
  const V ex = hn::Mul(hn::Sub(x, hn::Set(d, line.x)), perHalf);
  const V ey = hn::Mul(hn::Sub(hn::Set(d, y), hn::Set(d, line.y)), perHalf);
  const V along = hn::Mul(hn::Add(hn::Mul(ex, dx), hn::Mul(ey, dy)), hn::Set(d, line.perSquare));
  const V t =
    hn::IfThenElseZero(hn::Gt(along, zero), hn::IfThenElse(hn::Lt(along, one), along, one));
  const V u = hn::Sub(ex, hn::Mul(t, dx)), v = hn::Sub(ey, hn::Mul(t, dy));
  const V square = hn::Add(hn::Mul(u, u), hn::Mul(v, v));
  const M isCovered = hn::And(isWanted, hn::Le(square, one));
  if (hn::AllFalse(d, isCovered))
  {
    return isCovered;
  }
  const V az = hn::Set(d, line.az), bz = hn::Set(d, line.bz);
  V s = t;
  if (!IsParallel)
  {
    const V far = hn::Mul(t, az);
    s = hn::Div(far, hn::Add(far, hn::Mul(hn::Sub(one, t), bz)));
  }
  const V z = hn::Add(hn::Mul(hn::Sub(one, s), az), hn::Mul(s, bz));
  const V rise = hn::Sqrt(hn::Sub(one, square));
  const V bulge = hn::Set(d, line.bulge);
  depth = hn::Sub(z, hn::Mul(rise, IsParallel ? bulge : hn::Mul(bulge, z)));
  return hn::And(isCovered,
    hn::And(
      hn::Gt(depth, zero), hn::Lt(depth, hn::Set(d, std::numeric_limits<double>::infinity()))));
}

/// Appends the hits in the lanes of a mask.
HWY_INLINE void append(
  M hit, V depth, std::size_t sample, std::uint32_t number, std::vector<ExactHit>& hits)
{
  HWY_ALIGN double depths[lanesAtMost];
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, hit, bits);
  hn::Store(depth, d, depths);
  for (std::uint32_t left = bits[0]; left != 0; left &= left - 1)
  {
    const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
    hits.push_back({ static_cast<std::uint32_t>(sample + lane), number, depths[lane] });
  }
}

template <bool IsParallel>
void findHits(const CameraFrame& frame, const TileSamples& samples, const Line& line,
  std::uint32_t number, const Window& box, std::vector<ExactHit>& hits)
{
  const double *const xs = samples.xs(), *const ys = samples.ys();
  const LineBounds bounds(line);
  if (bounds.misses({ xs[box.i0], xs[box.i1 - 1] }, { ys[box.j0], ys[box.j1 - 1] }))
  {
    return;
  }
  const Columns columns(bounds, samples, frame.pixel, box);
  for (int j = box.j0; j < box.j1; ++j)
  {
    const Columns::Range range = columns.in(j);
    for (int i = range.begin; i < range.end; i += static_cast<int>(lanes))
    {
      const M inside = hn::FirstN(d, static_cast<std::size_t>(range.end - i));
      V depth = hn::Zero(d);
      const M hit = intersectRays<IsParallel>(line, hn::LoadU(d, xs + i), ys[j], inside, depth);
      if (!hn::AllFalse(d, hit))
      {
        append(hit, depth, static_cast<std::size_t>(j) * samples.stride() + i, number, hits);
      }
    }
  }
}

void FindLineHits(const CameraFrame& frame, const TileSamples& samples, const Line& line,
  std::uint32_t number, const Window& box, std::vector<ExactHit>& hits)
{
  frame.parallel ? findHits<true>(frame, samples, line, number, box, hits)
                 : findHits<false>(frame, samples, line, number, box, hits);
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(FindLineHits);

void findLineHits(const CameraFrame& frame, const TileSamples& samples, const Line& line,
  std::uint32_t number, const Window& box, std::vector<ExactHit>& hits)
{
  HWY_DYNAMIC_DISPATCH(FindLineHits)(frame, samples, line, number, box, hits);
}
}
#endif
