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
  constexpr auto step = static_cast<int>(lanes);
  for (int place = range.first / step * step; place < range.end; place += step)
  {
    const SamplePiece& piece = batch.pieces[place / SampleBatch::pieceSize];
    const int i = place % SampleBatch::pieceSize;
    const Runs runs(batch.run + place);
    const M isWanted = hn::Gt(runs(batch.isWanted), hn::Zero(d));
    if (i >= piece.width || hn::AllFalse(d, isWanted))
    {
      continue;
    }
    const VectorSurfacePoint point =
      points.at(runs, hn::LoadU(d, piece.xs + i), hn::Set(d, piece.y));
    store(point, eye, isWanted, result, place);
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
