// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ShadingKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorLights.h"
#include "VectorPointBatch.h"
#include "VectorSurfacePoints.h"

#include "ShadingKernel.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
Vector3 loadAt(const double (*rows)[SampleBatch::places], int place)
{
  return { hn::LoadU(d, rows[0] + place), hn::LoadU(d, rows[1] + place),
    hn::LoadU(d, rows[2] + place) };
}

/// Shades the samples of a range. reflectionAt(place) returns the reflection of several samples,
/// keep(point, isWanted, place) receives their surface points.
template <typename Points, typename Reflecting, typename Keep>
void shade(const Points& points, const LightModel& light, const RunRange& range,
  const Reflecting& reflectionAt, const Keep& keep, SampleBatch& batch)
{
  for (int place = VectorSamples::begin(range); place < range.end; place += static_cast<int>(lanes))
  {
    const VectorSamples samples(batch, place);
    if (samples.isEmpty())
    {
      continue;
    }
    const VectorSurfacePoint point = points.at(samples.runs, samples.x(), samples.y());
    keep(point, samples.isWanted, place);
    const Vector3 color = lit(light, reflectionAt(place), point);
    storeWhere(samples.isWanted, color.x, batch.colors[0] + place);
    storeWhere(samples.isWanted, color.y, batch.colors[1] + place);
    storeWhere(samples.isWanted, color.z, batch.colors[2] + place);
  }
}

template <typename Points, typename Keep>
void shade(const Points& points, const LightModel& light, const RunRange& range, const Keep& keep,
  SampleBatch& batch)
{
  if (range.appearance)
  {
    const SurfaceColor color = colorOf(*range.appearance);
    const Reflection reflection{ set(color.diffuse), set(color.ambient) };
    shade(
      points, light, range, [&](int) { return reflection; }, keep, batch);
  }
  else
  {
    shade(
      points, light, range,
      [&](int place) {
        return Reflection{ loadAt(batch.diffuse, place), loadAt(batch.ambient, place) };
      },
      keep, batch);
  }
}

template <bool HasSpheres>
HWY_INLINE void shadeRange(const SurfacePoints& points, const LightModel& light,
  const RunRange& range, SampleBatch& batch, PointBatch* result)
{
  const Vector3 eye = set(points.eye());
  withPoints<HasSpheres>(points, range, batch,
    [&](const auto& vectorPoints)
    {
      if (result)
      {
        shade(
          vectorPoints, light, range,
          [&](const VectorSurfacePoint& point, M isWanted, int place)
          { store(point, eye, isWanted, *result, place); },
          batch);
      }
      else
      {
        shade(
          vectorPoints, light, range, [](const VectorSurfacePoint&, M, int) {}, batch);
      }
    });
}

void ShadeTriangles(const SurfacePoints& points, const LightModel& light, const RunRange& range,
  SampleBatch& batch, PointBatch* result)
{
  shadeRange<false>(points, light, range, batch, result);
}

void ShadeSpheres(const SurfacePoints& points, const LightModel& light, const RunRange& range,
  SampleBatch& batch, PointBatch* result)
{
  shadeRange<true>(points, light, range, batch, result);
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(ShadeTriangles);
HWY_EXPORT(ShadeSpheres);

void shadeSamples(const SurfacePoints& points, const LightModel& light, const RunRange& range,
  SampleBatch& batch, PointBatch* result)
{
  range.hasSpheres ? HWY_DYNAMIC_DISPATCH(ShadeSpheres)(points, light, range, batch, result)
                   : HWY_DYNAMIC_DISPATCH(ShadeTriangles)(points, light, range, batch, result);
}
}
#endif
