// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief computes the colours of samples that hit triangles
 *
 * The kernel computes the surface points of several samples at a time (VectorTrianglePoints.h) and
 * lights them (VectorLights.h), keeping them in registers in between.
 */
#ifndef lambent_ShadingKernel_h
#define lambent_ShadingKernel_h

#include "LightModel.h"
#include "PointBatch.h"
#include "RunRange.h"
#include "TrianglePoints.h"

namespace lambent
{
/// Fills in the colours of the samples whose runs are wanted, and their surface points unless
/// `surfacePoints` is nullptr. The triangles of all runs of the range must be loaded, and their
/// reflection, too, unless the range has one appearance.
void shadeTriangles(const TrianglePoints& points, const LightModel& light, const RunRange& range,
  SampleBatch& batch, PointBatch* surfacePoints = nullptr);
}

#endif
