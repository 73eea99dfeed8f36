// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the colours of a batch of samples: surface points, then light
 *
 * A kernel shades the hits on surfaces that are shaded alike. Each colour has the bits of
 * LightModel::color() at SurfacePoints::at().
 */
#ifndef lambent_SampleShading_h
#define lambent_SampleShading_h

#include "LightModel.h"
#include "PointBatch.h"
#include "RunRange.h"
#include "SurfacePoints.h"

namespace lambent
{
class SampleShading
{
public:
  SampleShading(const SurfacePoints& points, const LightModel& light)
    : Points(points)
    , Light(light)
  {
  }

  /// Fills in the colours of the samples that hit something, and the parts of their runs. Also
  /// stores the surface points, if there is memory for them.
  void shade(SampleBatch& batch, PointBatch* points) const;

private:
  void shadeUnlit(const RunRange& range, SampleBatch& batch, PointBatch* points) const;

  const SurfacePoints& Points;
  const LightModel& Light;
};
}

#endif
