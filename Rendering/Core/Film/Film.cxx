// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Film.h"

#include "ByteKernel.h"
#include "ImageContract.h"

#include <algorithm>
#include <cstring>

namespace lambent
{
namespace
{
template <typename Channel>
void repeat(const Channel (&color)[3], int count, Channel* out)
{
  // Bits are compared: 0 equals -0, but is not the same.
  if (std::memcmp(color, color + 1, 2 * sizeof(Channel)) == 0)
  {
    std::fill_n(out, 3 * count, color[0]);
    return;
  }
  for (int i = 0; i < count; ++i)
  {
    std::copy_n(color, 3, out + 3 * i);
  }
}
}

Film::Film(const Scene& scene, const Image& image)
  : Target(image)
{
  this->Backgrounds.reserve(image.part.height());
  for (int j = 0; j < image.part.height(); ++j)
  {
    this->Backgrounds.push_back(this->backgroundOf(scene, j));
  }
}

Film::Background Film::backgroundOf(const Scene& scene, int j) const
{
  const int row = this->Target.part.j0 + j;
  Background result;
  result.color = scene.background +
    (scene.backgroundTop - scene.background) * ((row + 0.5) / this->Target.height);
  for (int channel = 0; channel < 3; ++channel)
  {
    result.bytes[channel] = toByte(result.color[channel]);
    result.floats[channel] = toFloat(result.color[channel]);
  }
  return result;
}

void Film::storeBackground(const Window& pixels) const
{
  for (int j = pixels.j0; j < pixels.j1; ++j)
  {
    const std::size_t first = this->pixel(pixels.i0, j);
    if (this->Target.triangles)
    {
      std::fill_n(this->Target.triangles + first, pixels.width(), noTriangle);
    }
    const Background& background = this->Backgrounds[j];
    if (this->Target.bytes)
    {
      repeat(background.bytes, pixels.width(), this->Target.bytes + 3 * first);
    }
    else
    {
      repeat(background.floats, pixels.width(), this->Target.floats + 3 * first);
    }
  }
}

void Film::storeColor(int i, int j, const Vec3& color) const
{
  const std::size_t first = 3 * this->pixel(i, j);
  for (int channel = 0; channel < 3; ++channel)
  {
    if (this->Target.bytes)
    {
      this->Target.bytes[first + channel] = toByte(color[channel]);
    }
    else
    {
      this->Target.floats[first + channel] = toFloat(color[channel]);
    }
  }
}

void Film::storeColors(
  int i, int j, int count, const double* red, const double* green, const double* blue) const
{
  const std::size_t first = 3 * this->pixel(i, j);
  if (this->Target.bytes)
  {
    storeBytes(red, green, blue, count, this->Target.bytes + first);
    return;
  }
  float* out = this->Target.floats + first;
  for (int k = 0; k < count; ++k)
  {
    *out++ = toFloat(red[k]);
    *out++ = toFloat(green[k]);
    *out++ = toFloat(blue[k]);
  }
}

void Film::storeTriangles(const Window& pixels, const std::uint32_t* triangles, int stride) const
{
  for (int row = 0; this->Target.triangles && row < pixels.height(); ++row)
  {
    std::copy_n(triangles + static_cast<std::size_t>(row) * stride, pixels.width(),
      this->Target.triangles + this->pixel(pixels.i0, pixels.j0 + row));
  }
}
}
