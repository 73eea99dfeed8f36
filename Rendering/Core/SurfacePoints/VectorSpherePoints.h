// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief SpherePoints::at() for several samples at a time, with the same bits in each lane
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorSpherePoints_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorSpherePoints_h
#undef lambent_VectorSpherePoints_h
#else
#define lambent_VectorSpherePoints_h
#endif

#include "LoadSpheres.h"
#include "SpherePoints.h"
#include "VectorSpheres.h"
#include "VectorSurfacePoint.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// The surface points of the samples whose runs are in a range. The spheres of all these runs must
/// be loaded.
class VectorSpherePoints
{
public:
  /// Transforms the centres of the runs into the frame.
  VectorSpherePoints(const SpherePoints& points, const RunRange& range, SampleBatch& batch)
    : Frame(points.mesh().frame())
    , IsTwoSided(points.isTwoSided())
    , Batch(batch)
  {
    const VectorFrame frame(this->Frame);
    double(*const rows)[SampleBatch::room] = batch.points + SphereRows::center;
    double(*const inFrame)[SampleBatch::room] = batch.points + SphereRows::centerInFrame;
    for (int k = range.firstRun; k < range.endRun; k += static_cast<int>(lanes))
    {
      const FrameVector v = frame.toFrame(
        hn::LoadU(d, rows[0] + k), hn::LoadU(d, rows[1] + k), hn::LoadU(d, rows[2] + k));
      hn::StoreU(v.x, d, inFrame[0] + k);
      hn::StoreU(v.y, d, inFrame[1] + k);
      hn::StoreU(v.z, d, inFrame[2] + k);
    }
  }

  /// The surface points where the rays through (x, y) hit the spheres of their runs.
  HWY_INLINE VectorSurfacePoint at(const Runs& runs, V x, V y) const
  {
    return this->Frame.parallel ? this->pointAt<true>(runs, x, y)
                                : this->pointAt<false>(runs, x, y);
  }

private:
  template <bool IsParallel>
  HWY_INLINE VectorSurfacePoint pointAt(const Runs& runs, V x, V y) const
  {
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
    const Vector3 center = runs(this->Batch.points + SphereRows::centerInFrame);
    // All rays hit, so that the inside is drawn where the outside is not seen.
    const VectorSphere sphere{ center.x, center.y, center.z,
      runs(this->Batch.points[SphereRows::radius]),
      hn::Gt(runs(this->Batch.points[SphereRows::hasOutside]), zero), hn::Ge(one, zero) };
    const VectorSphereHit hit(sphere, VectorApproach<IsParallel>(sphere, x, y));
    const Vector3 across = set(this->Frame.right) * x + set(this->Frame.up) * y;
    const Vector3 forward = set(this->Frame.forward);
    const Vector3 position =
      IsParallel ? across + forward * hit.depth : (across + forward) * hit.depth;
    const Vector3 normal =
      position - (runs(this->Batch.points + SphereRows::center) - set(this->Frame.eye));
    return { position, hit.depth, this->IsTwoSided ? negatedWhere(hit.isInside, normal) : normal,
      { one, zero, zero } };
  }

  const CameraFrame& Frame;
  bool IsTwoSided;
  const SampleBatch& Batch;
};
}
}
}
HWY_AFTER_NAMESPACE();
#endif
