// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief normals for smooth shading that leave sharp edges sharp: one a corner
 *
 * The definition, for a point P, the faces that name it, and a feature angle, to which 0.0001
 * degrees are added, so that rounded coordinates do not make every other edge of a cylinder of
 * twelve sides a sharp one:
 *
 * 1. The point's normal is that of PointNormals.h (angle-weighted), of all of its faces. If
 *    no face is steep there (Creases.h: further from the point's normal than half the
 *    feature angle), it is the normal of all corners at P.
 * 2. Otherwise the faces at P form groups. Two faces are in one group if they are linked by
 *    edges at P that are not sharp, across as many faces at P as need be. An edge P Q links
 *    two faces of which one runs from P to Q and the other from Q to P, unless
 *    - the angle between their normals is larger than the feature angle (180 degrees: never),
 *    - they are opposite faces: the same points, the other way round,
 *    - or that edge is more than 64 sides of faces.
 * 3. The normal of a corner is the sum of what the faces of its group add at P (angle-weighted,
 *    binary64, in ascending order of the faces), at unit length, rounded to float.
 * 4. A sum is no direction if it is shorter than 2^-20 of the sum of its terms' lengths: the
 *    terms cancel. Then each of the faces has its own normal there.
 *
 * Faces of no area belong to no group and add nothing; their corners have the normal of the
 * group with the smallest face. A sum of n terms is wrong by at most
 * (16 + n) 2^-53 times the lengths' sum, so a direction that counts is good to
 * (16 + n) 2^-33 radians. In step 1 the bound of
 * cosineOfHalf() (CornerRange.h) makes the same hold.
 *
 * So an edge is sharp or not whatever its place in the mesh, sheets whose faces are there
 * twice, once each way round, have normals on both sides, and neighbours that run opposite
 * ways do not cancel. Step 1 is what most points of a fine mesh need; only the others need
 * their faces listed and linked.
 *
 * How it runs: each range of points (RangeWalks.h) is walked three times, for the sums, the
 * creases and the corners at creased points, whose faces are then grouped point by point.
 */
#ifndef lambent_CornerNormals_h
#define lambent_CornerNormals_h

#include "PointNormals.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

namespace lambent
{
constexpr double featureAngleMargin = 1e-4; ///< degrees

/// No points are copied: a corner names its normal by a number of its own.
struct CornerNormals
{
  /// Three floats each: one for each point, then those that further corners need, ordered
  /// by point and by face.
  std::unique_ptr<float[]> normals;
  std::size_t count = 0;

  /// The number of the normal for each place of the faces' connectivity. nullptr: at each
  /// corner it is that of the point.
  std::unique_ptr<std::int32_t[]> numbers;
};

/// What numbers of 32 bits can tell apart.
constexpr std::size_t mostCornerNormals = std::numeric_limits<std::int32_t>::max();

/// Feature angle in degrees, 0 to 180. Throws std::runtime_error as soon as there are more
/// normals than `most` (tests take fewer) and corners that need numbers.
CornerNormals computeCornerNormals(const Faces& faces, double featureAngle,
  const Parallel& parallel, std::size_t most = mostCornerNormals);
}

#endif
