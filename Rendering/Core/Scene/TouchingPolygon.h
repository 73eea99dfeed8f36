// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief triangles of a polygon whose outline touches itself
 *
 * A corner named twice, a spike, or a slit that runs to a hole and back: such an
 * outline encloses an area as any other does, but its neighbouring corners may lie in
 * one place and its edges on each other. An ear of it is not found by looking for
 * corners inside a triangle alone:
 *
 * 1. The corners are projected along the axis that the normal is nearest to, which
 *    drops a coordinate and rounds nothing.
 * 2. Corners that enclose nothing are cut off first: one in the place of its neighbour,
 *    and the tip of an edge that runs back on itself. Their triangles have no area.
 * 3. Of the corners from the last cut on, the first ear is cut off: a convex corner
 *    whose triangle has no other corner in it or on its new edge, and no edge that leads
 *    into it from a corner on its other two. A corner may touch those from outside.
 *
 * Only corners that are not convex are looked for in a triangle: of those in it the one
 * that is farthest from the new edge is never convex.
 *
 * The triangles of an outline add up to it, each with its direction. So if none of them
 * is turned the other way, each place is covered as often as the outline winds round
 * it, once inside and never outside. That is how a result is known to be right.
 *
 * A distance to an edge of at most `tolerance` counts as none.
 */
#ifndef lambent_TouchingPolygon_h
#define lambent_TouchingPolygon_h

#include "ImageContract.h"

#include <cstddef>
#include <vector>

namespace lambent
{
/**
 * Writes the size - 2 triangles of a polygon of at least three corners, three numbers
 * of corners each. False if one of them would be turned the other way: the outline
 * crosses itself, by more than the tolerance. `triangles` is of no use then.
 */
bool cutTouchingPolygon(const std::vector<Vec3>& points, const Vec3& normal, double tolerance,
  std::vector<std::size_t>& triangles);
}

#endif
