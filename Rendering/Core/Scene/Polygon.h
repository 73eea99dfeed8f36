// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a copied polygon: its normal, its fan, and the area of triangles that face the wrong way
 */
#ifndef lambent_Polygon_h
#define lambent_Polygon_h

#include "ImageContract.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent
{
/// Writes a triangle to `out` and advances it.
inline void putTriangle(std::int32_t*& out, std::int32_t a, std::int32_t b, std::int32_t c)
{
  *out++ = a;
  *out++ = b;
  *out++ = c;
}

/// Twice the signed area of the triangle a b c, seen against the normal and multiplied by the
/// length of the normal.
inline double turn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal)
{
  return dot(cross(b - a, c - b), normal);
}

struct Polygon
{
  std::vector<std::int32_t> ids;
  std::vector<Vec3> points;
  Vec3 normal{ 0.0 };

  std::size_t size() const { return this->ids.size(); }
  std::size_t next(std::size_t k) const { return k + 1 == this->size() ? 0 : k + 1; }
  std::size_t previous(std::size_t k) const { return k == 0 ? this->size() - 1 : k - 1; }

  void findNormal()
  {
    this->normal = Vec3(0.0);
    for (std::size_t k = 0; k < this->size(); ++k)
    {
      this->normal = this->normal +
        cross(this->points[k] - this->points[0], this->points[this->next(k)] - this->points[0]);
    }
  }

  double turnAt(std::size_t k) const
  {
    return turn(
      this->points[this->previous(k)], this->points[k], this->points[this->next(k)], this->normal);
  }

  /// True if the outline turns the other way at some corner.
  bool isConcave() const
  {
    Vec3 in = this->points[0] - this->points[this->size() - 1];
    for (std::size_t k = 0; k < this->size(); ++k)
    {
      const Vec3 out = this->points[this->next(k)] - this->points[k];
      if (dot(cross(in, out), this->normal) < 0.0) // turnAt(k), computing each edge once
      {
        return true;
      }
      in = out;
    }
    return false;
  }

  void fan(std::int32_t*& out) const
  {
    for (std::size_t k = 2; k < this->size(); ++k)
    {
      putTriangle(out, this->ids[0], this->ids[k - 1], this->ids[k]);
    }
  }

  /// Twice the area of the triangles of the fan that face the other way.
  double turnedArea() const
  {
    double area = 0.0;
    for (std::size_t k = 2; k < this->size(); ++k)
    {
      area += turnedArea(0, k - 1, k);
    }
    return area;
  }

  /// The same for one triangle. Like all areas here, it is multiplied by the length of the normal.
  double turnedArea(std::size_t a, std::size_t b, std::size_t c) const
  {
    return std::max(-turn(this->points[a], this->points[b], this->points[c], this->normal), 0.0);
  }

  /// True if such an area can result from rounding, in the arithmetic or of the coordinates.
  /// `resolution` is that of the coordinates, relative to the largest one.
  bool isRounding(double turnedArea, double resolution) const
  {
    if (!(turnedArea > 0.0))
    {
      return true;
    }
    const double size = this->largestDistance();
    const double most = size * (0x1p-40 * size + resolution * this->largestCoordinate());
    return !(turnedArea > length(this->normal) * most);
  }

  /// The largest distance of a corner from the first.
  double largestDistance() const
  {
    double square = 0.0;
    for (const Vec3& p : this->points)
    {
      square = std::max(square, dot(p - this->points[0], p - this->points[0]));
    }
    return std::sqrt(square);
  }

  double largestCoordinate() const
  {
    double largest = 0.0;
    for (const Vec3& p : this->points)
    {
      largest = std::max({ largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z) });
    }
    return largest;
  }
};
}

#endif
