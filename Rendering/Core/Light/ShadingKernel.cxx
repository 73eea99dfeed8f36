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

#include "LineBatch.h"
#include "ShadingKernel.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// Shades the samples of a range. colorOf(runs, point, place) returns the colours of several
/// samples, keep(point, isWanted, place) receives their surface points.
template <typename Points, typename ColorOf, typename Keep>
void shade(const Points& points, const RunRange& range, const ColorOf& colorOf, const Keep& keep,
  SampleBatch& batch)
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
    const Vector3 color = colorOf(samples.runs, point, place);
    storeWhere(samples.isWanted, color.x, batch.colors[0] + place);
    storeWhere(samples.isWanted, color.y, batch.colors[1] + place);
    storeWhere(samples.isWanted, color.z, batch.colors[2] + place);
  }
}

/// Shades a range that has one colour.
template <typename Points, typename Keep>
void shadeUniform(const Points& points, const LightModel& light, const RunRange& range,
  const Keep& keep, SampleBatch& batch)
{
  const SurfaceColor color = colorOf(*range.appearance);
  const VectorSurfaceColor reflection{ set(color.diffuse), set(color.ambient) };
  shade(
    points, range,
    [&](const Runs&, const VectorSurfacePoint& point, int)
    { return lit(light, reflection, point); },
    keep, batch);
}

/// Shades a range with several colours, which may be unlit.
template <typename Points, typename Keep>
void shadeColored(const Points& points, const LightModel& light, const RunRange& range,
  const Keep& keep, SampleBatch& batch)
{
  const VectorColors colors(range, batch);
  shade(
    points, range,
    [&](const Runs& runs, const VectorSurfacePoint& point, int place)
    {
      const VectorSurfaceColor color = colors.at(runs, point, place);
      return range.isUnlit ? color.diffuse : lit(light, color, point);
    },
    keep, batch);
}

/// Shades a range with highlights.
template <typename Points, typename Keep>
void shadeShiny(const Points& points, const LightModel& light, const RunRange& range,
  const Keep& keep, SampleBatch& batch)
{
  const SurfaceColor uniform = range.appearance ? colorOf(*range.appearance) : SurfaceColor{};
  const VectorSurfaceColor reflection{ set(uniform.diffuse), set(uniform.ambient) };
  const VectorColors colors(range, batch);
  shade(
    points, range,
    [&](const Runs& runs, const VectorSurfacePoint& point, int place)
    {
      const VectorSurfaceColor color =
        range.appearance ? reflection : colors.at(runs, point, place);
      return lit(light, color, point) + highlights(light, *range.specular, point);
    },
    keep, batch);
}

template <bool HasSpheres>
HWY_INLINE void shadeRange(const SurfacePoints& points, const LightModel& light,
  const RunRange& range, SampleBatch& batch, PointBatch* result)
{
  const Vector3 eye = set(points.eye());
  const auto keep = [&](const VectorSurfacePoint& point, M isWanted, int place)
  {
    if (result)
    {
      store(point, eye, isWanted, *result, place);
    }
    if (range.hasTextures)
    {
      store(point.weights, isWanted, batch.weights, place);
    }
  };
  withPoints<HasSpheres>(points, range, batch,
    [&](const auto& vectorPoints)
    {
      if (range.specular)
      {
        shadeShiny(vectorPoints, light, range, keep, batch);
      }
      else if (!range.appearance || range.isUnlit)
      {
        shadeColored(vectorPoints, light, range, keep, batch);
      }
      else if (result || range.hasTextures)
      {
        shadeUniform(vectorPoints, light, range, keep, batch);
      }
      else
      {
        shadeUniform(
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
namespace
{
/// Shades a range of lines, one sample at a time.
void shadeLines(const SurfacePoints& points, const LightModel& light, const RunRange& range,
  SampleBatch& batch, PointBatch* result)
{
  forLinePoints(points, range, batch,
    [&](int place, const SurfacePoint& point)
    {
      const Vec3 color = light.color(point);
      for (int channel = 0; channel < 3; ++channel)
      {
        batch.colors[channel][place] = color[channel];
      }
      if (result)
      {
        store(point, points.eye(), *result, place);
      }
    });
}
}

HWY_EXPORT(ShadeTriangles);
HWY_EXPORT(ShadeSpheres);

void shadeSamples(const SurfacePoints& points, const LightModel& light, const RunRange& range,
  SampleBatch& batch, PointBatch* result)
{
  switch (range.kind)
  {
    case PrimitiveKind::Triangle:
      HWY_DYNAMIC_DISPATCH(ShadeTriangles)(points, light, range, batch, result);
      break;
    case PrimitiveKind::Sphere:
      HWY_DYNAMIC_DISPATCH(ShadeSpheres)(points, light, range, batch, result);
      break;
    case PrimitiveKind::Line:
      shadeLines(points, light, range, batch, result);
  }
}
}
#endif
