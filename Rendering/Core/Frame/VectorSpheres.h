// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief intersectSphere() for several rays at a time, with the same bits in each lane
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorSpheres_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorSpheres_h
#undef lambent_VectorSpheres_h
#else
#define lambent_VectorSpheres_h
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
/// A Sphere in each lane.
struct VectorSphere
{
  V x, y, z, radius;
  M hasOutside, hasInside;
};

/// How near the rays through (x, y) come to the centres of spheres; names as in intersectSphere().
template <bool IsParallel>
struct VectorApproach
{
  V a, b, fx, fy, square, disc;

  HWY_INLINE VectorApproach(const VectorSphere& s, V x, V y)
    : square(hn::Mul(s.radius, s.radius))
  {
    if (IsParallel)
    {
      this->a = hn::Set(d, 1.0);
      this->b = s.z;
      this->fx = hn::Sub(x, s.x);
      this->fy = hn::Sub(y, s.y);
      this->disc = hn::Sub(this->square, squareOf(this->fx, this->fy, hn::Zero(d)));
      return;
    }
    this->a = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Set(d, 1.0));
    this->b = hn::Add(hn::Add(hn::Mul(s.x, x), hn::Mul(s.y, y)), s.z);
    const V nearest = hn::Div(this->b, this->a);
    this->fx = s.x;
    this->fy = s.y;
    this->disc = hn::Sub(this->square,
      squareOf(hn::Sub(hn::Mul(nearest, x), s.x), hn::Sub(hn::Mul(nearest, y), s.y),
        hn::Sub(nearest, s.z)));
  }

  /// Whether a ray crosses the sphere, before or behind the eye. The radius must be positive.
  HWY_INLINE M isCrossing() const { return hn::Gt(this->disc, hn::Zero(d)); }

  static HWY_INLINE V squareOf(V x, V y, V z)
  {
    return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
  }
};

/// A SphereHit in each lane whose ray crosses its sphere.
struct VectorSphereHit
{
  V depth;
  M isInside;
  M isHit; ///< as intersectSphere() returns it

  template <bool IsParallel>
  HWY_INLINE VectorSphereHit(const VectorSphere& s, const VectorApproach<IsParallel>& ray)
  {
    const V zero = hn::Zero(d);
    const V c = hn::Sub(ray.squareOf(ray.fx, ray.fy, s.z), ray.square);
    const V root = hn::Sqrt(hn::Mul(ray.a, ray.disc));
    const M isAhead = hn::Gt(ray.b, zero);
    const V q = hn::IfThenElse(isAhead, hn::Add(ray.b, root), hn::Sub(ray.b, root));
    const V first = hn::Div(c, q), second = hn::Div(q, ray.a);
    const V outside = hn::IfThenElse(isAhead, first, second);
    const V inside = hn::IfThenElse(isAhead, second, first);
    const M isOutside = hn::And(s.hasOutside, hn::Gt(outside, zero));
    this->isInside = hn::Not(isOutside);
    this->depth = hn::IfThenElse(isOutside, outside, inside);
    this->isHit =
      hn::And(hn::And(hn::Gt(this->depth, zero),
                hn::Lt(this->depth, hn::Set(d, std::numeric_limits<double>::infinity()))),
        hn::Or(isOutside, s.hasInside));
  }
};
}
}
}
HWY_AFTER_NAMESPACE();
#endif
