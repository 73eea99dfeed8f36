// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceColor.h"

#include "RunRange.h"

namespace lambent
{
namespace
{
void put(const Vec3& color, double (*channels)[SampleBatch::places], int place)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    channels[channel][place] = color[channel];
  }
}
}

SurfaceColor colorOf(const Appearance& appearance)
{
  if (appearance.shading == Shading::Unlit)
  {
    return { true, appearance.diffuseColor, Vec3(0.0) };
  }
  return { false, appearance.diffuseReflection(), appearance.ambientReflection() };
}

void loadColors(const RunRange& range, SampleBatch& batch)
{
  SurfaceColor color{};
  std::int64_t last = -1; // the run with that colour
  for (int place = range.first; place < range.end; ++place)
  {
    const std::int64_t run = batch.run[place];
    if (!batch.isHit(place))
    {
      continue;
    }
    if (run != last)
    {
      color = colorOf(*batch.parts[run]->appearance);
      last = run;
    }
    put(color.diffuse, batch.diffuse, place);
    put(color.ambient, batch.ambient, place);
  }
}
}
