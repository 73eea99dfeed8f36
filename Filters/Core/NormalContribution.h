// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the contribution of one face to the normals at its corners
 *
 * This header defines the four weightings for every loop that uses them. Let N be the
 * area vector of the face (perpendicular to it, with twice its area as length), p a corner,
 * and u and v the edges from p to the next and to the previous corner:
 *
 *     Uniform   N / |N|
 *     Area      N
 *     Angle     N / |N| * (angle between u and v)
 *     Max       u x v / (|u|^2 |v|^2)
 *
 * Angle: G. Thuermer, C. A. Wuethrich, "Computing Vertex Normals from Polygonal
 * Facets", Journal of Graphics Tools 3(1), 1998. Max: N. Max, "Weights for
 * Computing Vertex Normals from Facet Normals", Journal of Graphics Tools 4(2),
 * 1999. Uniform: H. Gouraud, "Continuous Shading of Curved Surfaces", IEEE
 * Transactions on Computers C-20(6), 1971.
 *
 * N is Newell's vector (I. E. Sutherland, R. F. Sproull, R. A. Schumacker, "A
 * Characterization of Ten Hidden-Surface Algorithms", ACM Computing Surveys 6(1),
 * 1974), summed relative to the first corner, so that no precision is lost far from the
 * origin. In a triangle u x v is N at each corner.
 *
 * At a reflex corner the angle is 360 degrees minus that between the edges, and Max's vector
 * is negated, so that it lies on the side of N. So the sum does not depend on how a plane
 * region is divided into polygons.
 *
 * A face contributes nothing if |N|^2 is zero, subnormal (less than full precision) or
 * not finite. With Angle and Max, corners at edges of zero length contribute nothing either.
 *
 * To divide by a length, multiply by 1 / length: one division instead of three.
 * Angles are arctangents; see CornerAngles.h.
 */
#ifndef lambent_NormalContribution_h
#define lambent_NormalContribution_h

#include "Arithmetic.h"
#include "CornerAngles.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace lambent
{
enum class Weighting
{
  Uniform,
  Area,
  Angle,
  Max
};

/// False for zero, subnormal numbers, infinity and NaN.
inline bool isUsableSquare(double squaredLength)
{
  return squaredLength >= std::numeric_limits<double>::min() &&
    squaredLength <= std::numeric_limits<double>::max();
}

/// Calls add(corner, term) for the corners 0, 1, 2 of a triangle.
template <Weighting weighting, typename Add>
inline void contributeTriangle(const Vec3& a, const Vec3& b, const Vec3& c, Add&& add)
{
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 bc = c - b;
  const Vec3 area = cross(ab, ac);
  const double square = dot(area, area);
  if (!isUsableSquare(square))
  {
    return;
  }
  if constexpr (weighting == Weighting::Area)
  {
    add(0, area);
    add(1, area);
    add(2, area);
  }
  else if constexpr (weighting == Weighting::Uniform)
  {
    const Vec3 normal = area * (1.0 / std::sqrt(square));
    add(0, normal);
    add(1, normal);
    add(2, normal);
  }
  else if constexpr (weighting == Weighting::Angle)
  {
    const double areaLength = std::sqrt(square);
    const Vec3 normal = area * (1.0 / areaLength);
    const TriangleAngles angles = anglesOf(areaLength, dot(ab, ac), -dot(ab, bc), dot(ac, bc));
    add(0, normal * angles.a);
    add(1, normal * angles.b);
    add(2, normal * angles.c);
  }
  else
  {
    const double abSquare = dot(ab, ab);
    const double bcSquare = dot(bc, bc);
    const double acSquare = dot(ac, ac);
    add(0, area * (1.0 / (abSquare * acSquare)));
    add(1, area * (1.0 / (bcSquare * abSquare)));
    add(2, area * (1.0 / (acSquare * bcSquare)));
  }
}

/// Newell's vector of a face with any number of corners: perpendicular to it, with twice its area
/// as length. Zero if there are fewer than three corners.
template <typename Points, typename Id>
inline Vec3 areaVector(const Points& points, const Id* corners, std::size_t size)
{
  Vec3 area(0.0);
  if (size >= 3)
  {
    const Vec3 origin = points[corners[0]];
    Vec3 previous = points[corners[1]] - origin;
    for (std::size_t i = 2; i < size; ++i)
    {
      const Vec3 next = points[corners[i]] - origin;
      area = area + cross(previous, next);
      previous = next;
    }
  }
  return area;
}

/// The unit normal of a face, or zero if it has none.
template <typename Points, typename Id>
inline Vec3 faceNormal(const Points& points, const Id* corners, std::size_t size)
{
  const Vec3 area = areaVector(points, corners, size);
  const double square = dot(area, area);
  return isUsableSquare(square) ? area * (1.0 / std::sqrt(square)) : Vec3(0.0);
}

/// The contribution of a polygon with area vector `area` at the corner between the edges u (to the
/// next corner) and v (to the previous one).
template <Weighting weighting>
inline Vec3 cornerContribution(const Vec3& area, const Vec3& u, const Vec3& v)
{
  if constexpr (weighting == Weighting::Area)
  {
    return area;
  }
  const Vec3 normal = area * (1.0 / length(area));
  if constexpr (weighting == Weighting::Uniform)
  {
    return normal;
  }
  const Vec3 corner = cross(u, v);
  const bool isReflex = dot(corner, area) < 0.0;
  const double squares = dot(u, u) * dot(v, v);
  if (!isUsableSquare(squares))
  {
    return Vec3(0.0);
  }
  if constexpr (weighting == Weighting::Max)
  {
    return corner * ((isReflex ? -1.0 : 1.0) / squares);
  }
  constexpr double fullTurn = 6.283185307179586;
  const double angle = angleOf(length(corner), dot(u, v));
  return normal * (isReflex ? fullTurn - angle : angle);
}

/**
 * Calls add(point id, term) for the corners of a face, in order. Consecutive repeats of a point
 * count once. `scratch` keeps its memory between calls.
 */
template <Weighting weighting, typename Points, typename Id, typename Add>
inline void contributePolygon(
  const Points& points, const Id* corners, std::size_t size, std::vector<Id>& scratch, Add&& add)
{
  scratch.assign(corners, corners + size);
  scratch.erase(std::unique(scratch.begin(), scratch.end()), scratch.end());
  while (scratch.size() > 1 && scratch.back() == scratch.front())
  {
    scratch.pop_back();
  }
  const std::size_t count = scratch.size();
  const Vec3 area = areaVector(points, scratch.data(), count);
  if (!isUsableSquare(dot(area, area)))
  {
    return;
  }
  if (count == 3)
  {
    contributeTriangle<weighting>(points[scratch[0]], points[scratch[1]], points[scratch[2]],
      [&](int i, const Vec3& term) { add(scratch[i], term); });
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vec3 p = points[scratch[i]];
    const Vec3 u = points[scratch[i + 1 < count ? i + 1 : 0]] - p;
    const Vec3 v = points[scratch[i > 0 ? i - 1 : count - 1]] - p;
    add(scratch[i], cornerContribution<weighting>(area, u, v));
  }
}
}

#endif
