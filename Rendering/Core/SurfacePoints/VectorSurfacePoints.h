// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief SurfacePoints for several samples at a time, with the same bits in each lane
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorSurfacePoints_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorSurfacePoints_h
#undef lambent_VectorSurfacePoints_h
#else
#define lambent_VectorSurfacePoints_h
#endif

#include "LoadTriangles.h"
#include "SurfacePoints.h"
#include "VectorSpherePoints.h"
#include "VectorTrianglePoints.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// Calls body(points): points.at(runs, x, y) returns a VectorSurfacePoint of samples in the range,
/// whose kind of primitive is known when a kernel is compiled.
template <bool HasSpheres, typename Body>
HWY_INLINE void withPoints(
  const SurfacePoints& points, const RunRange& range, SampleBatch& batch, const Body& body)
{
  if constexpr (HasSpheres)
  {
    loadSpheres(range, batch);
    body(VectorSpherePoints(points.spheres(), range, batch));
  }
  else
  {
    loadTriangles(range, batch);
    body(VectorTrianglePoints(points.triangles(), range, batch));
  }
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
