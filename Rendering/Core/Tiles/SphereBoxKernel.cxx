// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "SphereBoxKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorFrame.h"

#include "SphereBoxKernel.h"

#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// Below it, squares may lose digits: they are not all normal numbers.
constexpr double smallestSquare = 1e-270;

constexpr double radiusSlack = 0x1p-46;
constexpr double tangentSlack = 0x1p-49;
constexpr double boundSlack = 0x1p-48;

struct Interval
{
  V low, high; ///< on the image plane
};

/// numerator / denominator, moved by `sign` times its error; infinite if it is no bound.
V bound(V numerator, V denominator, M isOutside, double sign)
{
  constexpr double largest = 1e15;
  const V value = hn::Div(numerator, denominator);
  const V error =
    hn::Mul(hn::Add(hn::Set(d, 1.0), hn::Mul(value, value)), hn::Set(d, sign * boundSlack));
  const M isBound = hn::And(hn::And(isOutside, hn::Gt(denominator, hn::Zero(d))),
    hn::Lt(hn::Abs(value), hn::Set(d, largest)));
  return hn::IfThenElse(
    isBound, hn::Add(value, error), hn::Set(d, sign * std::numeric_limits<double>::infinity()));
}

/// The bounds of a disc of radius R around (x, z), seen from the origin.
Interval tangents(V x, V z, V radius)
{
  const V zero = hn::Zero(d);
  const V square = hn::Add(hn::Mul(x, x), hn::Mul(z, z));
  const V tangent =
    hn::Sub(hn::Sub(square, hn::Mul(square, hn::Set(d, tangentSlack))), hn::Mul(radius, radius));
  const M isOutside = hn::Gt(tangent, zero);
  const V t = hn::Sqrt(hn::Max(tangent, zero));
  const V xt = hn::Mul(x, t), zt = hn::Mul(z, t);
  const V xr = hn::Mul(x, radius), zr = hn::Mul(z, radius);
  return { bound(hn::Sub(xt, zr), hn::Add(zt, xr), isOutside, -1.0),
    bound(hn::Add(xt, zr), hn::Sub(zt, xr), isOutside, 1.0) };
}

/// Stores the samples of an interval along an axis; none where `isDropped`.
void storeSamples(const PointLattice::Axis& axis, double perUnit, const Interval& interval,
  M isDropped, std::int32_t* begin, std::int32_t* end)
{
  const hn::Rebind<std::int32_t, D> di;
  const V zero = hn::Zero(d), last = hn::Set(d, axis.count);
  const V origin = hn::Set(d, axis.origin), margin = hn::Set(d, axis.margin);
  const V scale = hn::Set(d, perUnit);
  const V left = hn::Sub(hn::Add(hn::Mul(interval.low, scale), origin), margin);
  const V right = hn::Add(hn::Add(hn::Mul(interval.high, scale), origin), margin);
  const V first = hn::Min(hn::Max(hn::Ceil(left), zero), last);
  const V after = hn::Min(hn::Max(hn::Add(hn::Floor(right), hn::Set(d, 1.0)), zero), last);
  hn::StoreU(hn::DemoteTo(di, first), di, begin);
  hn::StoreU(hn::DemoteTo(di, hn::IfThenElse(isDropped, zero, after)), di, end);
}

void FindSphereBoxes(const PointLattice& lattice, SphereBoxes& boxes)
{
  const VectorFrame frame(lattice.frame());
  const V infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  for (int k = 0; k < boxes.count; k += static_cast<int>(lanes))
  {
    FrameVector c = frame.toFrame(hn::LoadU(d, boxes.centers[0] + k),
      hn::LoadU(d, boxes.centers[1] + k), hn::LoadU(d, boxes.centers[2] + k));
    const V radius = hn::LoadU(d, boxes.radii + k);
    const V distance =
      hn::Sqrt(hn::Add(hn::Add(hn::Mul(c.x, c.x), hn::Mul(c.y, c.y)), hn::Mul(c.z, c.z)));
    const V reach = hn::Add(distance, radius);
    const V square = hn::Mul(reach, reach);
    const M isOrdinary =
      hn::And(hn::Lt(square, infinity), hn::Gt(square, hn::Set(d, smallestSquare)));
    c.x = hn::IfThenElseZero(isOrdinary, c.x);
    c.y = hn::IfThenElseZero(isOrdinary, c.y);
    c.z = hn::IfThenElseZero(isOrdinary, c.z);
    const V larger =
      hn::IfThenElseZero(isOrdinary, hn::Add(radius, hn::Mul(reach, hn::Set(d, radiusSlack))));
    const M isDropped = hn::Or(hn::Not(isOrdinary), hn::Le(hn::Add(c.z, larger), hn::Zero(d)));
    const bool parallel = lattice.frame().parallel;
    const auto bounds = [&](V x)
    {
      return parallel ? Interval{ hn::Sub(x, larger), hn::Add(x, larger) }
                      : tangents(x, c.z, larger);
    };
    storeSamples(lattice.columns(), lattice.samplesPerUnit(), bounds(c.x), isDropped, boxes.i0 + k,
      boxes.i1 + k);
    storeSamples(
      lattice.rows(), lattice.samplesPerUnit(), bounds(c.y), isDropped, boxes.j0 + k, boxes.j1 + k);
    const V nothing = hn::Set(d, std::numeric_limits<double>::quiet_NaN());
    hn::StoreU(hn::IfThenElse(isOrdinary, hn::Sub(c.z, larger), nothing), d, boxes.nearest + k);
  }
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(FindSphereBoxes);

bool haveSphereBoxes(const PointLattice& lattice)
{
  constexpr double widest = 1e6; // in units of the image plane, at distance 1
  const auto reach = [&lattice](const PointLattice::Axis& axis)
  { return (std::fabs(axis.origin) + axis.count) * lattice.frame().pixel; };
  return lattice.isPrecise() &&
    (lattice.frame().parallel ||
      (reach(lattice.columns()) < widest && reach(lattice.rows()) < widest));
}

void findSphereBoxes(const PointLattice& lattice, SphereBoxes& boxes)
{
  HWY_DYNAMIC_DISPATCH(FindSphereBoxes)(lattice, boxes);
}
}
#endif
