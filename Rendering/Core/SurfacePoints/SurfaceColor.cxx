// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceColor.h"

#include "PointBatch.h"
#include "RunRange.h"

#include <hwy/cache_control.h>

namespace lambent
{
namespace
{
void put(const Vec3& color, double (*channels)[SampleBatch::room], int run)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    channels[channel][run] = color[channel];
  }
}

/// The alpha that colours of points have, or numbers of points that are looked up last.
double alphaAt(const SceneMesh::Part& part, const ColorArray& colors, std::uint32_t primitive,
  const PointBatch& points, int place)
{
  const std::size_t corners = Surface::cornersOf(part.kind());
  const std::size_t first = corners * (primitive - part.firstPrimitive);
  const auto weighted = [&](const auto& valueOf)
  {
    const auto at = [&](std::size_t corner)
    { return valueOf(part.corners()[first + corner]) * points.weights[corner][place]; };
    const double ofTwo = at(0) + at(1);
    return corners == 3 ? ofTwo + at(2) : ofTwo;
  };
  return part.colorSource() == ColorSource::MappedLast
    ? colors.table->alpha(weighted([&](std::size_t point) { return colors.number(point); }))
    : weighted([&](std::size_t point) { return colors.alpha(point); });
}
}

SurfaceColor colorOf(const Appearance& appearance)
{
  if (appearance.shading == Shading::Unlit)
  {
    return { true, appearance.diffuseColor, Vec3(0.0), appearance.opacity };
  }
  return { false, appearance.diffuseReflection(), appearance.ambientReflection(),
    appearance.opacity, appearance.shine() };
}

SurfaceColor colorOf(const Appearance& appearance, const Vec3& color, double alpha)
{
  const double opacity = appearance.opacity * alpha;
  if (appearance.shading == Shading::Unlit)
  {
    return { true, color, Vec3(0.0), opacity };
  }
  return { false, color * appearance.diffuse, color * appearance.ambient, opacity,
    appearance.shine() };
}

SurfaceColor colorOf(const Surface& surface, std::size_t primitive)
{
  const Appearance& appearance = surface.appearance;
  if (!surface.colors)
  {
    return colorOf(appearance);
  }
  const auto tuple = static_cast<std::size_t>(surface.cellOf(primitive));
  return colorOf(appearance, surface.colors->color(tuple), surface.colors->alpha(tuple));
}

void loadColors(const RunRange& range, SampleBatch& batch)
{
  const auto forRuns = [&](const auto& body)
  {
    for (int run = range.firstRun; run < range.endRun; ++run)
    {
      if (batch.primitives[run] != noPrimitive)
      {
        const SceneMesh::Part& part = *batch.parts[run];
        body(run, *part.surface, batch.primitives[run] - part.firstPrimitive);
      }
    }
  };
  forRuns(
    [](int, const Surface& surface, std::size_t primitive)
    {
      if (surface.colors) // scattered in memory
      {
        hwy::Prefetch(
          surface.colors->values.address(static_cast<std::size_t>(surface.cellOf(primitive))));
      }
    });
  forRuns(
    [&](int run, const Surface& surface, std::size_t primitive)
    {
      const SurfaceColor color = colorOf(surface, primitive);
      put(color.diffuse, batch.diffuse, run);
      put(color.ambient, batch.ambient, run);
    });
}

bool hasConstantOpacity(const SceneMesh::Part& part)
{
  return !part.hasTexture() && (part.hasOneColor() || part.colorSource() == ColorSource::Primitive);
}

double opacityAt(const SampleBatch& batch, const PointBatch& points, int place)
{
  const std::int64_t run = batch.run[place];
  const SceneMesh::Part& part = *batch.parts[run];
  const ColorArray* const colors = part.hasOneColor() ? nullptr : part.surface->colors;
  double opacity = part.appearance->opacity;
  if (colors && colors->hasAlpha)
  {
    const std::uint32_t primitive = batch.primitives[run];
    opacity = opacity *
      (part.colorSource() == ColorSource::Primitive
          ? colors->alpha(
              static_cast<std::size_t>(part.surface->cellOf(primitive - part.firstPrimitive)))
          : alphaAt(part, *colors, primitive, points, place));
  }
  return clampedOpacity(part.hasTexture() ? opacity * batch.textureAlphas[place] : opacity);
}
}
