// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the rays of a tile against a batch of triangles, decided in float where float can
 *
 * In the coordinates of the rays, columns and rows from the tile's first, the edge
 * function of corners p and q is affine,
 *
 *     E(i, j) = constant + i perColumn + j perRow
 *
 * and so is the nearness N(i, j) of the hit. The three numbers of each edge, and those of
 * N, are computed in binary64, once for the tile; each ray then takes a multiplication
 * and an addition in float.
 *
 * What is certain. An edge's numbers are divided by
 *
 *     size = |constant| + width |perColumn| + height |perRow|
 *
 * so that nothing in its evaluation exceeds 1. Rounding to float, two products and two
 * sums then err by less than 6 units of 2^-24. The binary64 arithmetic, here and in
 * intersect(), errs by fewer than 64 roundings of products of coordinates, bounded as
 * in "error" below. Where E is farther from zero than both together, it has the sign of
 * that in intersect(). All three of one sign: hit, and the ray lies within the box that
 * intersect() asks for, too. Two of different signs: no hit. Anything else is left to
 * intersect(), and so is a triangle that is not wholly before the eye, or whose numbers
 * floats do not hold.
 *
 * N = num / den, with the weights g and h of the edges
 *
 *     num = sum g E, den = sum h E     perspective: g = 1, h = z; parallel: g = -z, h = 1
 *
 * of which den is the same for all rays. What intersect() computes lies by at most
 * sum(error) (zmax - zmin) / |S| beside the true depth, where S, the sum of the edge
 * functions, is at least 2^-21 sum(size) for a certain hit; and always between the
 * corners' depths, to which the range is clipped.
 *
 * A triangle that is farther than all hits of the tile, or that certainly misses its
 * box, is done when its numbers are there.
 */
#ifndef lambent_CastingKernel_h
#define lambent_CastingKernel_h

#include "CameraFrame.h"
#include "CastBatch.h"
#include "Nearest.h"
#include "TileSamples.h"

namespace lambent
{
/// Keep the certain hits of the batch's triangles; put those that need their depth computed
/// into batch.hits. One overload for each policy.
void castBatch(
  const CameraFrame& frame, const TileSamples& samples, Nearest& nearest, CastBatch& batch);
}

#endif
