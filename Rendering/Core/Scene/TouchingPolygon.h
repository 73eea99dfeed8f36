// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cuts a polygon whose outline touches itself into triangles
 *
 * The outline may visit a corner twice, or contain a spike, or a slit that runs to a hole and back.
 * It encloses an area like any other outline, but neighbouring corners may coincide, and edges may
 * overlap. So looking for corners inside a triangle is not enough to find an ear:
 *
 * 1. Project the corners along the axis closest to the normal. This drops a coordinate and rounds
 *    nothing.
 * 2. Cut off the corners that enclose nothing: a corner that coincides with its neighbour, and the
 *    tip of an edge that runs back on itself. Their triangles have no area.
 * 3. Cut off the first ear, starting at the last cut: a convex corner whose triangle has no other
 *    corner inside or on its new edge, and no edge that enters it from a corner on its other two
 *    edges. A corner may touch those two from outside.
 *
 * Only corners that are not convex are searched for in a triangle: of the corners inside it, the
 * one farthest from the new edge is never convex.
 *
 * The triangles, with their orientations, add up to the outline. So if none of them faces the other
 * way, each point of the plane is covered as often as the outline winds round it: once inside,
 * never outside. This proves that a result is right.
 *
 * A distance to an edge of at most `tolerance` counts as zero.
 */
#ifndef lambent_TouchingPolygon_h
#define lambent_TouchingPolygon_h

#include "ImageContract.h"

#include <cstddef>
#include <vector>

namespace lambent
{
/**
 * Writes the size - 2 triangles of a polygon of at least three corners, as three corner numbers
 * each. Returns false if one of them would face the other way. Then the outline crosses itself by
 * more than the tolerance, and `triangles` is unusable.
 */
bool cutTouchingPolygon(const std::vector<Vec3>& points, const Vec3& normal, double tolerance,
  std::vector<std::size_t>& triangles);
}

#endif
