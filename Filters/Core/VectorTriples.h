// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vectors in space, several at a time, for kernels
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorTriples_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorTriples_h
#undef lambent_VectorTriples_h
#else
#define lambent_VectorTriples_h
#endif

#include "VectorDoubles.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
using DF = hn::Rebind<float, D>;
constexpr DF df;

V toDouble(V value)
{
  return value;
}

V toDouble(hn::Vec<DF> value)
{
  return hn::PromoteTo(d, value);
}

struct Vector3
{
  V x, y, z;
};

Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z) };
}

V dot(const Vector3& a, const Vector3& b)
{
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

V difference(V a, V b, V c, V e)
{
  return hn::Sub(hn::Mul(a, b), hn::Mul(c, e));
}

Vector3 cross(const Vector3& a, const Vector3& b)
{
  return { difference(a.y, b.z, a.z, b.y), difference(a.z, b.x, a.x, b.z),
    difference(a.x, b.y, a.y, b.x) };
}

M isUsable(V square)
{
  return hn::And(hn::Ge(square, hn::Set(d, std::numeric_limits<double>::min())),
    hn::Le(square, hn::Set(d, std::numeric_limits<double>::max())));
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
