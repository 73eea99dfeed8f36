// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a normal for each corner: smooth shading that keeps sharp edges sharp
 *
 * The definition, for a point P, the faces that name it, and a feature angle. 0.0001 degrees
 * are added to the angle; otherwise rounded coordinates would make every other edge of a
 * twelve-sided cylinder sharp.
 *
 * 1. The point's normal is the angle-weighted one of PointNormals.h, over all of its faces. If
 *    no face is steep at P (Creases.h: its normal is further from the point's than half the
 *    feature angle), all corners at P have the point's normal.
 * 2. Otherwise the faces at P form groups. Two faces are in the same group if a chain of faces
 *    at P, linked by edges at P, connects them. An edge P Q links two faces, one of which runs
 *    from P to Q and the other from Q to P, unless
 *    - the angle between their normals is larger than the feature angle (180 degrees: never),
 *    - they are opposite faces: the same points in reverse order,
 *    - or more than 64 sides of faces lie along that edge.
 * 3. The normal of a corner is the sum of the contributions of its group's faces at P
 *    (angle-weighted, binary64, in ascending order of the faces), scaled to unit length and
 *    rounded to float.
 * 4. If a sum is shorter than 2^-20 of the sum of its terms' lengths, the terms cancel and the
 *    sum has no direction. Then each face of the group has its own normal at P.
 *
 * Faces without area belong to no group and contribute nothing; their corners have the normal
 * of the group with the lowest face id. The error of a sum of n terms is at most
 * (16 + n) 2^-53 times the sum of the lengths, so a direction that is used is accurate to
 * (16 + n) 2^-33 radians. In step 1 the lower bound in cosineOfHalf() (CornerRange.h)
 * guarantees the same.
 *
 * So whether an edge is sharp does not depend on its place in the mesh. Sheets that contain
 * each face twice, once in each orientation, have normals on both sides. Neighbours of
 * opposite orientation do not cancel. Step 1 suffices for most points of a fine mesh; only the
 * others need their faces listed and linked.
 *
 * Each range of points (RangeWalks.h) takes three passes over its faces: for the sums, for the
 * creases, and for the corners at creased points. Then the faces at each creased point are
 * grouped.
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

/// No points are copied: each corner has the index of its normal.
struct CornerNormals
{
  /// Three floats each: one normal for each point, then the further ones that corners need,
  /// ordered by point and by face.
  std::unique_ptr<float[]> normals;
  std::size_t count = 0;

  /// The index of the normal for each entry of the faces' connectivity. nullptr: each corner has
  /// the normal of its point.
  std::unique_ptr<std::int32_t[]> numbers;
};

/// The most normals that 32-bit numbers can index.
constexpr std::size_t mostCornerNormals = std::numeric_limits<std::int32_t>::max();

/// The feature angle is in degrees, 0 to 180. Throws std::runtime_error as soon as some corners
/// need further normals and there are more than `most` normals in all (tests set it lower).
CornerNormals computeCornerNormals(const Faces& faces, double featureAngle,
  const Parallel& parallel, std::size_t most = mostCornerNormals);
}

#endif
