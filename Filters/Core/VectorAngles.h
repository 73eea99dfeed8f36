// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief CornerAngles.h for several triangles at a time, for kernels
 *
 * Each target includes this header once, hence the toggled guard.
 */
#if defined(lambent_VectorAngles_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorAngles_h
#undef lambent_VectorAngles_h
#else
#define lambent_VectorAngles_h
#endif

#include "CornerAngles.h"
#include "VectorLengths.h"

#include <cstddef>
#include <cstdint>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
using DI = hn::RebindToSigned<D>;
using I = hn::Vec<DI>;
constexpr DI di;
using DI32 = hn::Rebind<std::int32_t, D>;
constexpr DI32 di32;

V inverse(V a)
{
  return hn::Div(hn::Set(d, 1.0), a);
}

/// a + b t
V line(double a, double b, V t)
{
  return hn::Add(hn::Set(d, a), hn::Mul(t, hn::Set(d, b)));
}

struct VectorTurnedBack
{
  V quarters, y, x;
};

/// lambent::turnBack()
VectorTurnedBack turnBack(V y, V x)
{
  const V tangent = hn::Set(d, tangentOfEighth);
  const M isFlat = hn::Le(y, hn::Mul(tangent, x));
  const M isSteep = hn::Le(x, hn::Mul(tangent, y)); // not both, since y > 0
  const auto choose = [&](V flat, V steep, V other)
  { return hn::IfThenElse(isFlat, flat, hn::IfThenElse(isSteep, steep, other)); };
  return { choose(hn::Zero(d), hn::Set(d, 2.0), hn::Set(d, 1.0)),
    choose(y, hn::Neg(x), hn::Sub(y, x)), choose(x, y, hn::Add(y, x)) };
}

/// lambent::turnForth()
V turnForth(V quarters, V t)
{
  constexpr const double* c = arcTangentTail;
  const V z = hn::Mul(t, t);
  const V z2 = hn::Mul(z, z);
  const V z4 = hn::Mul(z2, z2);
  const V low = hn::Add(hn::Add(line(c[0], c[1], z), hn::Mul(z2, line(c[2], c[3], z))),
    hn::Mul(z4, hn::Add(line(c[4], c[5], z), hn::Mul(z2, line(c[6], c[7], z)))));
  const V high = hn::Add(line(c[8], c[9], z), hn::Mul(z2, hn::Set(d, c[10])));
  const V tail = hn::Add(low, hn::Mul(hn::Mul(z4, z4), high));
  const V rest = hn::Add(t, hn::Mul(t, hn::Mul(z, tail)));
  return hn::Add(hn::Mul(quarters, hn::Set(d, 0.25 * piHigh)),
    hn::Add(rest, hn::Mul(quarters, hn::Set(d, 0.25 * piLow))));
}

/// lambent::anglesOf(): the angles at a, b and c.
Vector3 anglesOf(V y, V xa, V xb, V xc)
{
  const M isLargestA = hn::And(hn::Le(xa, xb), hn::Le(xa, xc));
  const M isLargestB = hn::AndNot(isLargestA, hn::Le(xb, xc));
  const M isLargestC = hn::Not(hn::Or(isLargestA, isLargestB));
  const VectorTurnedBack p = turnBack(y, hn::IfThenElse(isLargestA, xb, xa));
  const VectorTurnedBack q = turnBack(y, hn::IfThenElse(isLargestC, xb, xc));
  const V product = hn::Mul(p.x, q.x);
  const M isHeld = hn::Le(product, hn::Set(d, std::numeric_limits<double>::max()));
  const V i = inverse(product);
  const V first = turnForth(p.quarters, hn::Mul(hn::Mul(p.y, q.x), i));
  const V second = turnForth(q.quarters, hn::Mul(hn::Mul(q.y, p.x), i));
  const V largest = hn::Sub(hn::Set(d, piHigh), hn::Add(first, second));
  return { hn::IfThenElseZero(isHeld, hn::IfThenElse(isLargestA, largest, first)),
    hn::IfThenElseZero(
      isHeld, hn::IfThenElse(isLargestB, largest, hn::IfThenElse(isLargestA, first, second))),
    hn::IfThenElseZero(isHeld, hn::IfThenElse(isLargestC, largest, second)) };
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
