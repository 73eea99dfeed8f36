// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "PointKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorPointBatch.h"
#include "VectorTrianglePoints.h"

#include "PointKernel.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
void ComputePoints(const TrianglePoints& trianglePoints, const RunRange& range, SampleBatch& batch,
  PointBatch& result)
{
  const VectorTrianglePoints points(trianglePoints, range, batch);
  const Vector3 eye = set(trianglePoints.mesh().frame().eye);
  for (int place = VectorSamples::begin(range); place < range.end; place += static_cast<int>(lanes))
  {
    const VectorSamples samples(batch, place);
    if (samples.isEmpty())
    {
      continue;
    }
    store(points.at(samples.runs, samples.x(), samples.y()), eye, samples.isWanted, result, place);
  }
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(ComputePoints);

void computePoints(
  const TrianglePoints& points, const RunRange& range, SampleBatch& batch, PointBatch& result)
{
  HWY_DYNAMIC_DISPATCH(ComputePoints)(points, range, batch, result);
}
}
#endif
