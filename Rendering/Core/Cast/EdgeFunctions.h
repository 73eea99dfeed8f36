// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief edge functions and others that are affine over the samples of a tile, for several
 * triangles at a time
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_EdgeFunctions_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_EdgeFunctions_h
#undef lambent_EdgeFunctions_h
#else
#define lambent_EdgeFunctions_h
#endif

#include "TileSamples.h"
#include "TriangleBatch.h"
#include "VectorFrame.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// constant + i perColumn + j perRow, one function per lane.
struct AffineFloats
{
  float constant[lanesAtMost], perColumn[lanesAtMost], perRow[lanesAtMost];
};

/// The position of a tile on the image plane.
struct TilePlane
{
  double x, y; ///< of its first sample
  double xMax, yMax;
  double pixel;
  double width, height; ///< in samples

  TilePlane(const CameraFrame& frame, const TileSamples& samples)
    : x(samples.xs()[0])
    , y(samples.ys()[0])
    , xMax(std::max(std::fabs(x), std::fabs(samples.xs()[samples.window().width() - 1])))
    , yMax(std::max(std::fabs(y), std::fabs(samples.ys()[samples.window().height() - 1])))
    , pixel(frame.pixel)
    , width(samples.window().width())
    , height(samples.window().height())
  {
  }
};

V sum(V a, V b, V c)
{
  return hn::Add(hn::Add(a, b), c);
}

V smallest(V a, V b, V c)
{
  return hn::Min(hn::Min(a, b), c);
}

V largest(V a, V b, V c)
{
  return hn::Max(hn::Max(a, b), c);
}

V scaled(V a, double factor)
{
  return hn::Mul(a, hn::Set(d, factor));
}

M isBelow(V a, double limit)
{
  return hn::Lt(a, hn::Set(d, limit)); // false for NaN
}

/// A function that is affine over the samples of a tile.
struct Affine
{
  V constant, perColumn, perRow;

  /// A bound on its terms, and on its values in the tile.
  V size(const TilePlane& tile) const
  {
    return sum(hn::Abs(this->constant), scaled(hn::Abs(this->perColumn), tile.width),
      scaled(hn::Abs(this->perRow), tile.height));
  }

  Affine times(V factor) const
  {
    return { hn::Mul(this->constant, factor), hn::Mul(this->perColumn, factor),
      hn::Mul(this->perRow, factor) };
  }

  void store(AffineFloats& out) const
  {
    const hn::Rebind<float, D> df;
    hn::StoreU(hn::DemoteTo(df, this->constant), df, out.constant);
    hn::StoreU(hn::DemoteTo(df, this->perColumn), df, out.perColumn);
    hn::StoreU(hn::DemoteTo(df, this->perRow), df, out.perRow);
  }
};

Affine weightedSum(const Affine edges[3], const V weights[3])
{
  const auto of = [&](V Affine::*part)
  {
    return sum(hn::Mul(edges[0].*part, weights[0]), hn::Mul(edges[1].*part, weights[1]),
      hn::Mul(edges[2].*part, weights[2]));
  };
  return { of(&Affine::constant), of(&Affine::perColumn), of(&Affine::perRow) };
}

/// The smallest and largest value over a box.
struct Extremes
{
  V low, high;
};

/// The boxes of several triangles: centres and half extents.
struct Boxes
{
  V column, row, columns, rows;

  Boxes(const TriangleBatch& batch, int k)
  {
    HWY_ALIGN double ends[4][lanesAtMost];
    for (int lane = 0; lane < static_cast<int>(lanes); ++lane)
    {
      const Window& box = batch.boxes[k + lane];
      ends[0][lane] = box.i0;
      ends[1][lane] = box.i1 - 1;
      ends[2][lane] = box.j0;
      ends[3][lane] = box.j1 - 1;
    }
    const auto halved = [](V a) { return scaled(a, 0.5); };
    const V i0 = hn::Load(d, ends[0]), i1 = hn::Load(d, ends[1]);
    const V j0 = hn::Load(d, ends[2]), j1 = hn::Load(d, ends[3]);
    this->column = halved(hn::Add(i0, i1));
    this->row = halved(hn::Add(j0, j1));
    this->columns = halved(hn::Sub(i1, i0));
    this->rows = halved(hn::Sub(j1, j0));
  }

  Extremes of(const Affine& e) const
  {
    const V middle =
      sum(e.constant, hn::Mul(e.perColumn, this->column), hn::Mul(e.perRow, this->row));
    const V reach =
      hn::Add(hn::Mul(hn::Abs(e.perColumn), this->columns), hn::Mul(hn::Abs(e.perRow), this->rows));
    return { hn::Sub(middle, reach), hn::Add(middle, reach) };
  }
};

/// The edge function of corners p and q. error: a bound on the rounding errors of this function and
/// of that in intersect().
Affine edgeFunction(const FrameVector& p, const FrameVector& q, const TilePlane& tile, V& error)
{
  const V constant = hn::Sub(hn::Mul(p.x, q.y), hn::Mul(p.y, q.x));
  const V perX = hn::Sub(hn::Mul(p.y, q.w), hn::Mul(p.w, q.y));
  const V perY = hn::Sub(hn::Mul(p.w, q.x), hn::Mul(p.x, q.w));
  const auto bound = [](V coordinate, V w, double most)
  { return hn::Add(hn::Abs(coordinate), scaled(hn::Abs(w), most)); };
  const V products = hn::Add(hn::Mul(bound(p.x, p.w, tile.xMax), bound(q.y, q.w, tile.yMax)),
    hn::Mul(bound(p.y, p.w, tile.yMax), bound(q.x, q.w, tile.xMax)));
  error =
    hn::Add(scaled(products, std::ldexp(1.0, -46)), hn::Set(d, std::numeric_limits<double>::min()));
  return { sum(constant, scaled(perX, tile.x), scaled(perY, tile.y)), scaled(perX, tile.pixel),
    scaled(perY, tile.pixel) };
}

}
}
}
HWY_AFTER_NAMESPACE();
#endif
