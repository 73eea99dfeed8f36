// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief intersect() for several rays at a time, with the same bits in each lane
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorHits_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorHits_h
#undef lambent_VectorHits_h
#else
#define lambent_VectorHits_h
#endif

#include "VectorFrame.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
inline M spansZero(V a, V b, V c)
{
  const V zero = hn::Zero(d);
  const M below = hn::Or(hn::Or(hn::Le(a, zero), hn::Le(b, zero)), hn::Le(c, zero));
  const M above = hn::Or(hn::Or(hn::Ge(a, zero), hn::Ge(b, zero)), hn::Ge(c, zero));
  return hn::And(below, above);
}

/// A triangle whose vertices are sheared so that the ray through (x, y) becomes the third axis.
struct ShearedTriangle
{
  V ax, ay, bx, by, cx, cy;

  ShearedTriangle(const FrameVector& a, const FrameVector& b, const FrameVector& c, V x, V y)
    : ax(hn::Sub(a.x, hn::Mul(x, a.w)))
    , ay(hn::Sub(a.y, hn::Mul(y, a.w)))
    , bx(hn::Sub(b.x, hn::Mul(x, b.w)))
    , by(hn::Sub(b.y, hn::Mul(y, b.w)))
    , cx(hn::Sub(c.x, hn::Mul(x, c.w)))
    , cy(hn::Sub(c.y, hn::Mul(y, c.w)))
  {
  }

  /// Whether the ray lies in the triangle's bounding box.
  M spansRay() const
  {
    return hn::And(
      spansZero(this->ax, this->bx, this->cx), spansZero(this->ay, this->by, this->cy));
  }
};

/// A Hit in each lane, even where the triangle is missed.
struct VectorHit
{
  V e0, e1, e2, sum, depth;

  VectorHit(const ShearedTriangle& t, V az, V bz, V cz)
    : e0(hn::Sub(hn::Mul(t.bx, t.cy), hn::Mul(t.by, t.cx)))
    , e1(hn::Sub(hn::Mul(t.cx, t.ay), hn::Mul(t.cy, t.ax)))
    , e2(hn::Sub(hn::Mul(t.ax, t.by), hn::Mul(t.ay, t.bx)))
    , sum(hn::Add(hn::Add(e0, e1), e2))
    , depth(hn::Div(hn::Add(hn::Add(hn::Mul(e0, az), hn::Mul(e1, bz)), hn::Mul(e2, cz)), sum))
  {
  }

  /// True where intersect() returns true, for a ray in the triangle's box.
  M isHit() const
  {
    const V zero = hn::Zero(d);
    // NaN may pass here, but then the depth is NaN, too.
    const M front = hn::Ge(hn::Min(hn::Min(this->e0, this->e1), this->e2), zero);
    const M back = hn::Le(hn::Max(hn::Max(this->e0, this->e1), this->e2), zero);
    return hn::And(hn::Or(front, back),
      hn::And(hn::Gt(this->depth, zero),
        hn::Lt(this->depth, hn::Set(d, std::numeric_limits<double>::infinity()))));
  }
};
}
}
}
HWY_AFTER_NAMESPACE();
#endif
