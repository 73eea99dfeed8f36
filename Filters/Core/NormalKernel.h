// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the two loops of point normals, for several triangles and points at a time
 *
 * Lane by lane the arithmetic is that of contributeTriangle() and writeNormal(), in
 * the same order, and so are the bits. What a batch of triangles contributes is
 * computed at once, then added one corner after the other, in the order of the
 * corners: a triangle without area adds zero here and nothing there, which is the
 * same, since a sum is never -0.
 *
 * Of the time for a large mesh a third goes into the contributions and as much into
 * fetching the points and adding up; the rest into checks, clearing and writing.
 *
 * Both return how many they have done, the first ones; the caller does the others.
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
/// Adds what the triangles contribute; triangle i names the points corners[3 i] to
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
