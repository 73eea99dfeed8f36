// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the two loops of point normals, vectorized
 *
 * Each lane does the arithmetic of contributeTriangle() and writeNormal() in the same
 * order, so the bits are the same. The contributions of a batch of triangles are computed
 * together, then added corner by corner in order. A triangle without area adds zero here,
 * and nothing in the scalar code; the result is the same, since a sum is never -0.
 *
 * For a large mesh, a third of the time goes into the contributions, another third into
 * fetching points and adding, and the rest into checks, clearing and writing.
 *
 * Both functions return how many triangles or sums they have processed, from the first
 * on. The caller processes the rest.
 */
#ifndef lambent_NormalKernel_h
#define lambent_NormalKernel_h

#include "NormalContribution.h"
#include "PointSums.h"
#include "Spans.h"

#include <cstddef>
#include <cstdint>

namespace lambent
{
/// Adds the contributions of triangles. Triangle i has the points corners[3 i] to
/// corners[3 i + 2].
///@{
std::size_t addTriangles(Weighting weighting, const TupleSpan& points, const std::int32_t* corners,
  std::size_t count, PointSums& sums);
std::size_t addTriangles(Weighting weighting, const TupleSpan& points, const std::int64_t* corners,
  std::size_t count, PointSums& sums);
///@}

/// Writes three floats for each sum.
std::size_t writeNormals(const PointSum* sums, std::size_t count, float sign, float* normals);
}

#endif
