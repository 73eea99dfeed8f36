// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "PointKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorPointBatch.h"
#include "VectorSurfacePoints.h"

#include "LineBatch.h"
#include "PointKernel.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
template <bool HasSpheres>
HWY_INLINE void computeRange(
  const SurfacePoints& points, const RunRange& range, SampleBatch& batch, PointBatch& result)
{
  const Vector3 eye = set(points.eye());
  withPoints<HasSpheres>(points, range, batch,
    [&](const auto& vectorPoints)
    {
      for (int place = VectorSamples::begin(range); place < range.end;
           place += static_cast<int>(lanes))
      {
        const VectorSamples samples(batch, place);
        if (!samples.isEmpty())
        {
          store(vectorPoints.at(samples.runs, samples.x(), samples.y()), eye, samples.isWanted,
            result, place);
        }
      }
    });
}

void ComputeTrianglePoints(
  const SurfacePoints& points, const RunRange& range, SampleBatch& batch, PointBatch& result)
{
  computeRange<false>(points, range, batch, result);
}

void ComputeSpherePoints(
  const SurfacePoints& points, const RunRange& range, SampleBatch& batch, PointBatch& result)
{
  computeRange<true>(points, range, batch, result);
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(ComputeTrianglePoints);
HWY_EXPORT(ComputeSpherePoints);

void computePoints(
  const SurfacePoints& points, const RunRange& range, SampleBatch& batch, PointBatch& result)
{
  switch (range.kind)
  {
    case PrimitiveKind::Triangle:
      HWY_DYNAMIC_DISPATCH(ComputeTrianglePoints)(points, range, batch, result);
      break;
    case PrimitiveKind::Sphere:
      HWY_DYNAMIC_DISPATCH(ComputeSpherePoints)(points, range, batch, result);
      break;
    case PrimitiveKind::Line:
      computeLinePoints(points, range, batch, result);
  }
}
}
#endif
