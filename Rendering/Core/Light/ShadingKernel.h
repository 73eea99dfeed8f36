// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the colours of the samples that hit triangles
 *
 * For several samples at a time their surface points are found (VectorTrianglePoints.h) and
 * lit (VectorLights.h), without leaving the registers in between.
 */
#ifndef lambent_ShadingKernel_h
#define lambent_ShadingKernel_h

#include "LightModel.h"
#include "SampleBatch.h"
#include "TrianglePoints.h"

namespace lambent
{
/// Fill in the colours of the samples whose runs are wanted. The triangles of all runs of the
/// range, and their reflection unless the range has one appearance, must have been loaded.
void shadeTriangles(
  const TrianglePoints& points, const LightModel& light, const RunRange& range, SampleBatch& batch);
}

#endif
