// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief how near a hit is, as a range of floats that certainly holds it
 *
 * The nearness of a hit is 1 / depth in a perspective view and -depth in a parallel
 * one: over a triangle either is an affine function of the ray, and the larger one is
 * the nearer hit. Where the ranges of two hits do not overlap they tell which of them
 * is nearer; where they do, the depths have to be computed.
 */
#ifndef lambent_Nearness_h
#define lambent_Nearness_h

#include <limits>

namespace lambent
{
struct Nearness
{
  float low, high;
};

/// Of no hit: farther than all.
constexpr Nearness noNearness{ -std::numeric_limits<float>::infinity(),
  -std::numeric_limits<float>::infinity() };

/// How much wider, relatively, a range is made than what it was computed from: more than
/// a few roundings to float.
constexpr float nearnessSlack = 1.0f / (1 << 21);

/// Depths between which floats, and their reciprocals, round as they should.
constexpr double smallestRangedDepth = 1e-30, largestRangedDepth = 1e30;

/// Of a hit at a depth. What floats do not hold gets a range that overlaps with all.
inline Nearness nearnessOf(double depth, bool parallel)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  if (!(depth > smallestRangedDepth && depth < largestRangedDepth))
  {
    return { -infinity, infinity };
  }
  const auto value = static_cast<float>(parallel ? depth : 1.0 / depth);
  const float less = value * (1.0f - nearnessSlack), more = value * (1.0f + nearnessSlack);
  return parallel ? Nearness{ -more, -less } : Nearness{ less, more };
}
}

#endif
