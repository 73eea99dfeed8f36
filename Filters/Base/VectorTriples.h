// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief several 3D vectors at a time, for kernels
 *
 * Each target includes this header once, hence the toggled guard.
 */
#if defined(lambent_VectorTriples_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorTriples_h
#undef lambent_VectorTriples_h
#else
#define lambent_VectorTriples_h
#endif

#include "Arithmetic.h"
#include "VectorDoubles.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
struct Vector3
{
  V x, y, z;
};

inline Vector3 set(const Vec3& v)
{
  return { hn::Set(d, v.x), hn::Set(d, v.y), hn::Set(d, v.z) };
}

inline Vector3 operator+(const Vector3& a, const Vector3& b)
{
  return { hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z) };
}

inline Vector3 operator-(const Vector3& a, const Vector3& b)
{
  return { hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z) };
}

inline Vector3 operator*(const Vector3& a, V s)
{
  return { hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s) };
}

inline Vector3 operator*(const Vector3& a, const Vector3& b)
{
  return { hn::Mul(a.x, b.x), hn::Mul(a.y, b.y), hn::Mul(a.z, b.z) };
}

inline V dot(const Vector3& a, const Vector3& b)
{
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

inline V difference(V a, V b, V c, V e)
{
  return hn::Sub(hn::Mul(a, b), hn::Mul(c, e));
}

inline Vector3 cross(const Vector3& a, const Vector3& b)
{
  return { difference(a.y, b.z, a.z, b.y), difference(a.z, b.x, a.x, b.z),
    difference(a.x, b.y, a.y, b.x) };
}

/// -v where the mask is set, otherwise v.
inline Vector3 negatedWhere(M mask, const Vector3& v)
{
  return { hn::IfThenElse(mask, hn::Neg(v.x), v.x), hn::IfThenElse(mask, hn::Neg(v.y), v.y),
    hn::IfThenElse(mask, hn::Neg(v.z), v.z) };
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
