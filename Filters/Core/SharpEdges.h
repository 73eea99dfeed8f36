// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cut a mesh open along its sharp edges
 *
 * Two faces go smoothly into each other where they share an edge that no third
 * face uses and the angle between their normals is not larger than the feature
 * angle. Round each point the faces that are linked by such edges form groups; each
 * group but the first gets a copy of the point:
 *
 * 1. List the corners at each point, in ascending order of face.
 * 2. At each point pair the corners whose edges lead to the same other point, and
 *    join the two where their edge is smooth (union-find; the smallest corner leads).
 * 3. Groups are ordered by their first face. The first keeps the point; copies are
 *    numbered on from the last point, by point, then by group.
 *
 * A face without a normal (no area, or not finite) is sharp against every other.
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
  std::vector<std::int64_t> connectivity; ///< as that of the faces, with the copies' ids
  std::vector<std::int64_t> copiedPoints; ///< the point that copy i is a copy of
};

/// Feature angle in degrees, 0 to 180; at 180 no edge of two faces is sharp.
SplitMesh splitSharpEdges(const Faces& faces, double featureAngle, const Parallel& parallel);
}

#endif
