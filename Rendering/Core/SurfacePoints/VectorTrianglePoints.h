// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief TrianglePoints::at() for several samples at a time, with the same bits in each lane
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorTrianglePoints_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorTrianglePoints_h
#undef lambent_VectorTrianglePoints_h
#else
#define lambent_VectorTrianglePoints_h
#endif

#include "RunRange.h"
#include "TrianglePoints.h"
#include "VectorHits.h"
#include "VectorSurfacePoint.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
inline Vector3 load(const double (*rows)[SampleBatch::room], int k)
{
  return { hn::LoadU(d, rows[0] + k), hn::LoadU(d, rows[1] + k), hn::LoadU(d, rows[2] + k) };
}

/// Negates the normals of the runs [k, k + lanes) whose triangle a b c is reversed
/// (TrianglePoints::isReversed()).
inline void turnReversed(
  const Vector3& a, const Vector3& b, const Vector3& c, bool isSmooth, int k, SampleBatch& batch)
{
  Vector3 given = load(batch.normals, k);
  if (isSmooth)
  {
    given = (given + load(batch.normals + 3, k)) + load(batch.normals + 6, k);
  }
  const M isReversed = hn::Lt(dot(cross(b - a, c - a), given), hn::Zero(d));
  for (int row = 0; !hn::AllFalse(d, isReversed) && row < (isSmooth ? 9 : 3); ++row)
  {
    const V value = hn::LoadU(d, batch.normals[row] + k);
    hn::StoreU(hn::IfThenElse(isReversed, hn::Neg(value), value), d, batch.normals[row] + k);
  }
}

inline void storeInFrame(
  const VectorFrame& frame, const Vector3& p, double (*rows)[SampleBatch::room], int k)
{
  const FrameVector v = frame.toFrame(p.x, p.y, p.z);
  hn::StoreU(v.x, d, rows[0] + k);
  hn::StoreU(v.y, d, rows[1] + k);
  hn::StoreU(v.z, d, rows[2] + k);
}

/// The surface points of the samples whose runs are in a range. The triangles of all these runs
/// must be loaded.
class VectorTrianglePoints
{
public:
  /// Transforms the corners of the runs into the frame, and negates the normals of reversed
  /// triangles.
  VectorTrianglePoints(const TrianglePoints& points, const RunRange& range, SampleBatch& batch)
    : Frame(points.mesh().frame())
    , IsSmooth(range.isSmooth)
    , IsTurned(points.isTwoSided() != range.isSmooth)
    , Batch(batch)
  {
    const VectorFrame frame(this->Frame);
    for (int k = range.firstRun; k < range.endRun; k += static_cast<int>(lanes))
    {
      const Vector3 a = load(batch.points, k), b = load(batch.points + 3, k),
                    c = load(batch.points + 6, k);
      if (range.hasGivenNormals && points.isTwoSided())
      {
        turnReversed(a, b, c, range.isSmooth, k, batch);
      }
      storeInFrame(frame, a, batch.points, k);
      storeInFrame(frame, b, batch.points + 3, k);
      storeInFrame(frame, c, batch.points + 6, k);
    }
  }

  /// The surface points where the rays through (x, y) hit the triangles of their runs.
  HWY_INLINE VectorSurfacePoint at(const Runs& runs, V x, V y) const
  {
    const auto corner = [&](int k)
    {
      const Vector3 p = runs(this->Batch.points + 3 * k);
      return FrameVector{ p.x, p.y, p.z, this->Frame.parallel ? hn::Set(d, 1.0) : p.z };
    };
    const FrameVector a = corner(0), b = corner(1), c = corner(2);
    const VectorHit hit(ShearedTriangle(a, b, c, x, y), a.z, b.z, c.z);
    const Vector3 across = set(this->Frame.right) * x + set(this->Frame.up) * y;
    const Vector3 forward = set(this->Frame.forward);
    return { this->Frame.parallel ? across + forward * hit.depth : (across + forward) * hit.depth,
      hit.depth, this->normal(runs, hit),
      { hn::Div(hit.e0, hit.sum), hn::Div(hit.e1, hit.sum), hn::Div(hit.e2, hit.sum) } };
  }

private:
  HWY_INLINE Vector3 normal(const Runs& runs, const VectorHit& hit) const
  {
    Vector3 normal = runs(this->Batch.normals);
    if (this->IsSmooth)
    {
      normal = (normal * hit.e0 + runs(this->Batch.normals + 3) * hit.e1) +
        runs(this->Batch.normals + 6) * hit.e2;
    }
    return this->IsTurned ? negatedWhere(hn::Lt(hit.sum, hn::Zero(d)), normal) : normal;
  }

  const CameraFrame& Frame;
  bool IsSmooth, IsTurned; ///< IsTurned: negate the normal on the back
  const SampleBatch& Batch;
};
}
}
}
HWY_AFTER_NAMESPACE();
#endif
