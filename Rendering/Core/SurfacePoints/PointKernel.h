// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief computes the surface points of samples, for passes
 */
#ifndef lambent_PointKernel_h
#define lambent_PointKernel_h

#include "PointBatch.h"
#include "RunRange.h"
#include "SurfacePoints.h"

namespace lambent
{
/// Fills in the surface points of the samples of a range. Loads its primitives.
void computePoints(
  const SurfacePoints& points, const RunRange& range, SampleBatch& batch, PointBatch& result);
}

#endif
