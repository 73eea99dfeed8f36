// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what one face adds to the normals at its corners
 *
 * The definition of the four weightings, once, for every loop that sums them up.
 * With N the area vector of the face (normal to it, twice its area long), p a
 * corner, u and v the edges from p to the next and to the previous corner:
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
 * 1974), summed relative to the first corner, so that nothing is lost far from the
 * origin. In a triangle u x v is N at each corner.
 *
 * At a corner of more than 180 degrees the angle is what the two edges leave of a
 * full turn, and Max's vector is turned to the side of N; so the sum does not
 * depend on how a plane region is cut into polygons.
 *
 * A face whose |N|^2 is zero or not finite adds nothing. So do, with Angle and
 * Max, corners at edges of no length.
 */
#ifndef lambent_NormalContribution_h
#define lambent_NormalContribution_h

#include "Elementary.h"
#include "ImageContract.h"

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

/// False for zero, infinity, and what is not a number.
inline bool isUsableSquare(double squaredLength)
{
  return squaredLength > 0.0 && squaredLength <= std::numeric_limits<double>::max();
}

/// The angle between two edges of these lengths with this scalar product.
inline double angleBetween(double scalarProduct, double lengths)
{
  return arcCosine(std::max(-1.0, std::min(scalarProduct / lengths, 1.0)));
}

/// Calls add(corner, compute) for the corners 0, 1, 2 of a triangle; compute() gives
/// the contribution, and need not be called where that is not wanted.
template <Weighting weighting, typename Add>
inline void contributeTriangle(const Vec3& a, const Vec3& b, const Vec3& c, Add&& add)
{
  const Vec3 ab = b - a;
  const Vec3 bc = c - b;
  const Vec3 ca = a - c;
  const Vec3 area = cross(ab, c - a);
  const double square = dot(area, area);
  if (!isUsableSquare(square))
  {
    return;
  }
  if constexpr (weighting == Weighting::Area)
  {
    add(0, [&] { return area; });
    add(1, [&] { return area; });
    add(2, [&] { return area; });
  }
  else if constexpr (weighting == Weighting::Uniform)
  {
    const Vec3 normal = area * (1.0 / std::sqrt(square));
    add(0, [&] { return normal; });
    add(1, [&] { return normal; });
    add(2, [&] { return normal; });
  }
  else if constexpr (weighting == Weighting::Angle)
  {
    const Vec3 normal = area * (1.0 / std::sqrt(square));
    const double abLength = length(ab);
    const double bcLength = length(bc);
    const double caLength = length(ca);
    add(0, [&] { return normal * angleBetween(-dot(ab, ca), abLength * caLength); });
    add(1, [&] { return normal * angleBetween(-dot(bc, ab), bcLength * abLength); });
    add(2, [&] { return normal * angleBetween(-dot(ca, bc), caLength * bcLength); });
  }
  else
  {
    const double abSquare = dot(ab, ab);
    const double bcSquare = dot(bc, bc);
    const double caSquare = dot(ca, ca);
    add(0, [&] { return area * (1.0 / (abSquare * caSquare)); });
    add(1, [&] { return area * (1.0 / (bcSquare * abSquare)); });
    add(2, [&] { return area * (1.0 / (caSquare * bcSquare)); });
  }
}

/// Newell's vector of a face of any number of corners: normal to it, and twice its
/// area long. Zero if there are fewer than three.
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

/// What a polygon of area vector `area` adds at the corner p between the edges u
/// (to the next corner) and v (to the previous one).
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
  const double angle = angleBetween(dot(u, v), length(u) * length(v));
  return normal * (isReflex ? fullTurn - angle : angle);
}

/**
 * Calls add(point id, compute) for the corners of a face, in their order. A point
 * that is named twice in a row counts once. `scratch` keeps its memory from
 * one call to the next.
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
      [&](int i, auto&& compute) { add(scratch[i], compute); });
    return;
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    add(scratch[i],
      [&]
      {
        const Vec3 p = points[scratch[i]];
        const Vec3 u = points[scratch[i + 1 < count ? i + 1 : 0]] - p;
        const Vec3 v = points[scratch[i > 0 ? i - 1 : count - 1]] - p;
        return cornerContribution<weighting>(area, u, v);
      });
  }
}
}

#endif
