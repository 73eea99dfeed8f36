// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceColor.h"

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
}

SurfaceColor colorOf(const Appearance& appearance)
{
  if (appearance.shading == Shading::Unlit)
  {
    return { true, appearance.diffuseColor, Vec3(0.0) };
  }
  return { false, appearance.diffuseReflection(), appearance.ambientReflection(),
    appearance.shine() };
}

SurfaceColor colorOf(const Appearance& appearance, const Vec3& color)
{
  if (appearance.shading == Shading::Unlit)
  {
    return { true, color, Vec3(0.0) };
  }
  return { false, color * appearance.diffuse, color * appearance.ambient, appearance.shine() };
}

SurfaceColor colorOf(const Surface& surface, std::size_t primitive)
{
  const Appearance& appearance = surface.appearance;
  return surface.colors
    ? colorOf(
        appearance, surface.colors->color(static_cast<std::size_t>(surface.cellOf(primitive))))
    : colorOf(appearance);
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
}
