// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief split a mesh along its sharp edges
 *
 * An edge is smooth if exactly two faces share it and the angle between their normals is
 * not larger than the feature angle. The faces around each point form groups that are linked
 * by smooth edges. Each group but the first gets a copy of the point:
 *
 * 1. List the corners at each point, in ascending order of face.
 * 2. At each point, pair the corners whose edges lead to the same other point, and
 *    join the two if their edge is smooth (union-find; the smallest corner is the root).
 * 3. Order the groups by their first face. The first keeps the point. The copies are
 *    numbered after the last point, by point, then by group.
 *
 * All edges of a face without a normal (no area, or not finite) are sharp.
 */
#ifndef lambent_SharpEdges_h
#define lambent_SharpEdges_h

#include "PointNormals.h"

#include <cstdint>
#include <vector>

namespace lambent
{
struct SplitMesh
{
  std::vector<std::int64_t> connectivity; ///< that of the faces, with the ids of copies
  std::vector<std::int64_t> copiedPoints; ///< the point that copy i is a copy of
};

/// The feature angle is in degrees, 0 to 180. At 180 no edge between two faces with normals is
/// sharp.
SplitMesh splitSharpEdges(const Faces& faces, double featureAngle, const Parallel& parallel);
}

#endif
