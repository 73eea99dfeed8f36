// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the nearness of a hit, as a range of floats that is certain to contain it
 *
 * The nearness is 1 / depth in a perspective view and -depth in a parallel view. Over a triangle,
 * both are affine functions of the ray. The nearer hit has the larger nearness. If the ranges of
 * two hits do not overlap, they decide which hit is nearer. Otherwise the depths must be computed.
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

/// The nearness of no hit: farther than any hit.
constexpr Nearness noNearness{ -std::numeric_limits<float>::infinity(),
  -std::numeric_limits<float>::infinity() };

/// The relative margin added to a computed range: more than a few roundings to float.
constexpr float nearnessSlack = 1.0f / (1 << 21);

/// Between these depths, floats and their reciprocals neither overflow nor underflow.
constexpr double smallestRangedDepth = 1e-30, largestRangedDepth = 1e30;

/// The depths of the corners bound the depth that intersect() computes only if no product of
/// sheared coordinates underflows. So a corner's x and y in the frame must be 0 or larger than
/// smallestCoordinate, pixels larger than smallestPixel, and depths within the limits above. Then
/// all sheared coordinates are 0 or at least about 1e-123.
constexpr double smallestCoordinate = 1e-120, smallestPixel = 1e-60;

inline bool isZeroOrOrdinary(double coordinate)
{
  return coordinate == 0.0 || coordinate > smallestCoordinate || coordinate < -smallestCoordinate;
}

/// The nearness range of a known depth. A depth outside the limits gets a range that overlaps all
/// others.
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
