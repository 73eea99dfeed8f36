// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief tests the rays of a tile against a batch of triangles, in float where float is certain
 *
 * In the coordinates of the samples, columns and rows from the first of the tile, the edge function
 * of corners p and q is affine,
 *
 *     E(i, j) = constant + i perColumn + j perRow
 *
 * and so is the nearness N(i, j) of the hit. The three numbers of each edge, and those of N, are
 * computed once for the tile, in binary64. Each sample then needs one multiplication and one
 * addition in float.
 *
 * Certain hits. The numbers of an edge are divided by
 *
 *     size = |constant| + width |perColumn| + height |perRow|
 *
 * so that nothing in its evaluation exceeds 1. Rounding to float, two products and two sums then
 * err by less than 6 units of 2^-24. The binary64 arithmetic, here and in intersect(), errs by
 * fewer than 64 roundings of products of coordinates, bounded as in "error" below. Where E is
 * farther from zero than the sum of both errors, it has the same sign as in intersect(). If all
 * three have one sign, the ray hits, and the sample lies within the box that intersect() requires.
 * If two have different signs, it misses. Anything else is left to intersect(), and so are
 * triangles that are not wholly in front of the eye, or whose numbers are out of the range of
 * float.
 *
 * N = num / den, with the weights g and h of the edges
 *
 *     num = sum g E, den = sum h E     perspective: g = 1, h = z; parallel: g = -z, h = 1
 *
 * where den is the same for all samples. The depth that intersect() computes differs from the true
 * depth by at most sum(error) (zmax - zmin) / |S|, where S, the sum of the edge functions, is at
 * least 2^-21 sum(size) for a certain hit. It always lies between the depths of the corners, to
 * which the range is clipped.
 *
 * A triangle that is farther than all hits of the tile, or that certainly misses its box, is
 * skipped once its numbers are computed.
 */
#ifndef lambent_CastingKernel_h
#define lambent_CastingKernel_h

#include "CameraFrame.h"
#include "Layers.h"
#include "TileSamples.h"
#include "TriangleBatch.h"

namespace lambent
{
/// Keeps the certain hits of the batch's triangles, and puts those whose depth must be computed
/// into batch.hits. Returns a lower bound on the nearness of each sample's hit before that. There
/// is one overload per policy.
float castBatch(
  const CameraFrame& frame, const TileSamples& samples, Nearest& nearest, TriangleBatch& batch);
float castBatch(
  const CameraFrame& frame, const TileSamples& samples, Layers& layers, TriangleBatch& batch);
}

#endif
