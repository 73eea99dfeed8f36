// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief vectors of three doubles, in the arithmetic of the image contract
 *
 * Only the type comes from GLM. GLM's dot() and normalize() may change the order of their sums
 * from one release to the next; the functions here must not (ImageContract.h).
 */
#ifndef lambent_Arithmetic_h
#define lambent_Arithmetic_h

#include <glm/vec3.hpp>

#include <cmath>

namespace lambent
{
using Vec3 = glm::dvec3;

inline double dot(const Vec3& a, const Vec3& b)
{
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}

inline Vec3 cross(const Vec3& a, const Vec3& b)
{
  return { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
}

inline double length(const Vec3& a)
{
  return std::sqrt(dot(a, a));
}

inline Vec3 normalized(const Vec3& a)
{
  const double l = length(a);
  return { a.x / l, a.y / l, a.z / l };
}

inline bool isFinite(const Vec3& v)
{
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
}

#endif
