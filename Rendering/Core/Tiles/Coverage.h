// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief which rays small triangles cover, decided in float where float can
 *
 * Most triangles of a fine mesh cover a ray or none. For these, exact arithmetic is
 * spent only where it is needed. With the projections u, v of the corners in rays,
 * as floats, the edge function of corners a, b at the ray p is
 *
 *     E = (b_u - a_u) (p_v - a_v) - (b_v - a_v) (p_u - a_u)
 *
 * and has the sign of the edge function in intersect() wherever it is farther from
 * zero than its error. All three certainly of one sign: hit. Two certainly of
 * different signs: no hit. Anything else: uncertain, and left to intersect().
 *
 * The error bound. d: by how much a float u or v can differ from the exact
 * projection, half a unit in the last place of the largest coordinate, plus the
 * rounding of the projection itself. w, h: the triangle's extent, as floats. The ray
 * lies in the triangle's box (boxes here are exact), so |p - a| is at most the extent
 * plus d. Then
 *
 * - moving the corners by d changes E by at most 2d |p_v - a_v| + d |b_u - a_u| + 2d
 *   |p_u - a_u| + d |b_v - a_v| and second-order terms: at most 3d (w + h) + 8 d^2;
 * - evaluating it rounds each of the four differences, both products and the result:
 *   at most 8 units of 2^-24 w h;
 * - intersect() computes its edge functions in binary64, in coordinates that are those
 *   of the rays but for a factor, with errors that are as large relative to d as
 *   2^-53 is to 2^-24.
 *
 * 4 d (w + h + 2 d) + 2^-20 w h is larger than the sum of the three. Triangles that
 * are much larger than their box (they reach beyond the image) are always uncertain, and
 * so are those that are not wholly before the eye.
 *
 * The depth of a hit lies between those of the corners, which is all that is kept of
 * it: see Nearness.h.
 */
#ifndef lambent_Coverage_h
#define lambent_Coverage_h

#include "Nearness.h"
#include "PointLattice.h"

#include <cstdint>

namespace lambent
{
/// A triangle whose box is exact and of few rays.
struct SmallTriangle
{
  std::uint32_t number;
  std::uint32_t part;      ///< of the scene's surfaces
  std::int32_t corners[3]; ///< points of that surface
  std::int32_t i, j;       ///< the lower left ray of the box
};

/// Those with boxes of one size, of surfaces of which both sides are seen.
struct SmallTriangles
{
  static constexpr int capacity = 32;
  /// Boxes of at most so many rays along an axis are small.
  static constexpr int side = 8;

  int count = 0;
  SmallTriangle items[capacity];
};

/// The same as the kernel wants them.
struct CoverageBatch
{
  int count = 0;
  int width, height; ///< of the boxes
  std::uint32_t triangles[SmallTriangles::capacity];
  std::int32_t i[SmallTriangles::capacity], j[SmallTriangles::capacity];
  /// The corners: ax, ay, az, bx, ... in the world.
  alignas(64) double points[9][SmallTriangles::capacity];
};

/// A triangle by its place in the batch, and a ray of its box, from the lower left one.
struct CoveredRay
{
  std::uint32_t bits;

  static constexpr std::uint32_t at(int i, int j) { return i << 8 | j << 16; } // of the first
  int triangle() const { return this->bits & 0xFF; }
  int i() const { return this->bits >> 8 & 0xFF; }
  int j() const { return this->bits >> 16; }
};

/// The rays that they cover.
struct CoveredRays
{
  // Each of a batch's triangles with each ray of its box, and room for a vector.
  static constexpr int capacity =
    SmallTriangles::capacity * SmallTriangles::side * SmallTriangles::side + 16;

  int certain = 0, uncertain = 0;
  CoveredRay certainRays[capacity], uncertainRays[capacity];
  /// The nearness of each triangle's hits.
  float lows[SmallTriangles::capacity], highs[SmallTriangles::capacity];
};

/// Results are put in anew.
void findCoverage(const CoverageBatch& batch, const PointLattice& lattice, CoveredRays& covered);
}

#endif
