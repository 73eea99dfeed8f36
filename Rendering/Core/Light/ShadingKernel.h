// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief computes the colours of samples
 *
 * The kernel computes the surface points of several samples at a time (VectorSurfacePoints.h) and
 * lights them (VectorLights.h), keeping them in registers in between.
 */
#ifndef lambent_ShadingKernel_h
#define lambent_ShadingKernel_h

#include "LightModel.h"
#include "PointBatch.h"
#include "RunRange.h"
#include "SurfacePoints.h"

namespace lambent
{
/// Computes the colours of the samples in a range, and stores their surface points, too, unless
/// `result` is nullptr. If the range has several colours or is unlit, and their source is the
/// primitives, loadColors() must have been called. Textures are not applied, but the weights that
/// they need are stored in the batch.
void shadeSamples(const SurfacePoints& points, const LightModel& light, const RunRange& range,
  SampleBatch& batch, PointBatch* result = nullptr);
}

#endif
