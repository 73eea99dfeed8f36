// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief computes the surface points of samples that hit triangles, for passes
 */
#ifndef lambent_PointKernel_h
#define lambent_PointKernel_h

#include "RunRange.h"
#include "TrianglePoints.h"

namespace lambent
{
/// The surface points of a batch, by place. Undefined where a sample hits nothing.
struct PointBatch
{
  double depth[SampleBatch::places];
  double normal[3][SampleBatch::places];   ///< of length 1
  double position[3][SampleBatch::places]; ///< in the world
  double weights[3][SampleBatch::places];
};

/// Fills in the surface points of the samples of a range. Its triangles must be loaded.
void computePoints(
  const TrianglePoints& points, const RunRange& range, SampleBatch& batch, PointBatch& result);
}

#endif
