// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief stores surface points in a PointBatch
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorPointBatch_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorPointBatch_h
#undef lambent_VectorPointBatch_h
#else
#define lambent_VectorPointBatch_h
#endif

#include "PointBatch.h"
#include "VectorSurfacePoint.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
inline void store(const Vector3& v, M isWanted, double (*rows)[SampleBatch::places], int place)
{
  storeWhere(isWanted, v.x, rows[0] + place);
  storeWhere(isWanted, v.y, rows[1] + place);
  storeWhere(isWanted, v.z, rows[2] + place);
}

/// Stores the points of the lanes that are wanted, from a place on.
inline void store(
  const VectorSurfacePoint& point, const Vector3& eye, M isWanted, PointBatch& batch, int place)
{
  const V length = hn::Sqrt(dot(point.normal, point.normal));
  const Vector3 normal{ hn::Div(point.normal.x, length), hn::Div(point.normal.y, length),
    hn::Div(point.normal.z, length) };
  storeWhere(isWanted, point.depth, batch.depth + place);
  store(normal, isWanted, batch.normal, place);
  store(eye + point.position, isWanted, batch.position, place);
  store(point.weights, isWanted, batch.weights, place);
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
