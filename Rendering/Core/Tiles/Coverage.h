// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief which samples small triangles cover, decided in float where float is certain
 *
 * Most triangles of a fine mesh cover one sample or none. For these, exact arithmetic is used only
 * where it is needed. Let u, v be the projections of the corners in samples, as floats. The edge
 * function of corners a, b at the sample p is
 *
 *     E = (b_u - a_u) (p_v - a_v) - (b_v - a_v) (p_u - a_u)
 *
 * It has the sign of the edge function in intersect() wherever it is farther from zero than its
 * error. If all three certainly have the same sign, the sample's ray hits. If two certainly have
 * different signs, it misses. Anything else is uncertain and left to intersect().
 *
 * The error bound. Let d be the largest difference between a float u or v and the exact projection:
 * half a unit in the last place of the largest coordinate, plus the rounding of the projection
 * itself. Let w, h be the extent of the triangle, as floats. The sample lies in the box of the
 * triangle (boxes here are exact), so |p - a| is at most the extent plus d. Then
 *
 * - moving the corners by d changes E by at most 2d |p_v - a_v| + d |b_u - a_u| + 2d |p_u - a_u| +
 *   d |b_v - a_v| and second-order terms: at most 3d (w + h) + 8 d^2;
 * - evaluating E rounds each of the four differences, both products and the result: at most 8 units
 *   of 2^-24 w h;
 * - intersect() computes its edge functions in binary64, in the coordinates of the samples except
 *   for a factor. Its errors are smaller than those from d by the ratio of 2^-53 to 2^-24.
 *
 * 4 d (w + h + 2 d) + 2^-20 w h is larger than the sum of the three. Triangles much larger than
 * their box (they reach beyond the image) are always uncertain, and so are triangles that are not
 * wholly in front of the eye.
 *
 * Only a range is kept of the depth of a hit: it lies between the depths of the corners. See
 * Nearness.h.
 */
#ifndef lambent_Coverage_h
#define lambent_Coverage_h

#include "Nearness.h"
#include "PointLattice.h"

#include <cstdint>

namespace lambent
{
/// A triangle whose box is exact and contains few samples.
struct SmallTriangle
{
  std::uint32_t number;
  std::int32_t corners[3]; ///< point numbers in its surface
  LatticePosition first;   ///< the lower left sample of the box
};

/// Small triangles with boxes of one size, from surfaces without culling.
struct SmallTriangles
{
  static constexpr int capacity = 32;
  /// Boxes of at most this many samples along each axis are small.
  static constexpr int side = 8;

  int count = 0;
  SmallTriangle items[capacity];
};

/// The same triangles in the layout of the kernel.
struct CoverageBatch
{
  int count = 0;
  int width, height; ///< of the boxes
  std::uint32_t triangles[SmallTriangles::capacity];
  std::int32_t i[SmallTriangles::capacity], j[SmallTriangles::capacity];
  /// The corners in world coordinates: ax, ay, az, bx, ...
  alignas(64) double points[9][SmallTriangles::capacity];
};

/// A triangle by its place in the batch, and a sample of its box, counted from the lower left one.
struct CoveredSample
{
  std::uint32_t bits;

  static constexpr std::uint32_t at(int i, int j) { return i << 8 | j << 16; } // of triangle 0
  int triangle() const { return this->bits & 0xFF; }
  int i() const { return this->bits >> 8 & 0xFF; }
  int j() const { return this->bits >> 16; }
};

/// The samples that the triangles of a batch cover, certainly or perhaps.
struct CoveredSamples
{
  // Every sample of every box of a batch, and room for a vector.
  static constexpr int capacity =
    SmallTriangles::capacity * SmallTriangles::side * SmallTriangles::side + 16;

  int certain = 0, uncertain = 0;
  CoveredSample certainSamples[capacity], uncertainSamples[capacity];
  /// The nearness range of each triangle's hits.
  float lows[SmallTriangles::capacity], highs[SmallTriangles::capacity];
};

/// Replaces the contents of `covered`.
void findCoverage(const CoverageBatch& batch, const PointLattice& lattice, CoveredSamples& covered);
}

#endif
