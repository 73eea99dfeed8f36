// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Painting.h"

namespace lambent
{
void Painting::paint(const NearestHits& hits) const
{
  const Window& rays = hits.window();
  const Window& part = this->Target.part;
  for (int j = rays.j0; j < rays.j1; ++j)
  {
    const double y = this->Frame.y(part.j0 + j);
    const Vec3 background = this->background(part.j0 + j);
    std::size_t index = hits.index(rays.i0, j);
    std::size_t pixel = static_cast<std::size_t>(j) * part.width() + rays.i0;
    for (int i = rays.i0; i < rays.i1; ++i, ++index, ++pixel)
    {
      const std::uint32_t triangle = hits.triangle(index);
      this->store(pixel,
        triangle == noTriangle ? background
                               : this->Colors.color(triangle, this->Frame.x(part.i0 + i), y));
    }
  }
}

Vec3 Painting::background(int j) const
{
  const Vec3& bottom = this->Description.background;
  const Vec3& top = this->Description.backgroundTop;
  return bottom + (top - bottom) * ((j + 0.5) / this->Target.height);
}

void Painting::store(std::size_t pixel, const Vec3& color) const
{
  for (int channel = 0; channel < 3; ++channel)
  {
    if (this->Target.bytes)
    {
      this->Target.bytes[3 * pixel + channel] = toByte(color[channel]);
    }
    else
    {
      this->Target.floats[3 * pixel + channel] = static_cast<float>(color[channel]);
    }
  }
}
}
