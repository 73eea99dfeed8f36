// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Film.h"

#include "AverageKernel.h"
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
  // Compare bits: 0 equals -0, but has other bits.
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
  const Window samples = image.samplePart();
  const double height = static_cast<double>(image.height) * image.samples;
  for (int j = samples.j0; j < samples.j1; ++j)
  {
    this->SampleBackgrounds.push_back(
      scene.background + (scene.backgroundTop - scene.background) * ((j + 0.5) / height));
  }
  for (int j = 0; j < image.part.height(); ++j)
  {
    this->Backgrounds.push_back(this->backgroundOf(j));
  }
}

Film::Background Film::backgroundOf(int j) const
{
  const int n = this->Target.samples;
  Background result;
  result.color =
    average(n, [&](int, int row) -> const Vec3& { return this->SampleBackgrounds[j * n + row]; });
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

void Film::storeAverages(const Window& pixels, const TileColors& colors, int row) const
{
  constexpr int size = 32, room = size + 8;
  double averages[3][room] = {};
  const int n = this->Target.samples;
  for (int j = pixels.j0; j < pixels.j1; ++j, row += n)
  {
    for (int begin = 0; begin < pixels.width(); begin += size)
    {
      const int count = std::min(size, pixels.width() - begin);
      for (int channel = 0; channel < 3; ++channel)
      {
        averageSamples(
          colors.row(channel, row) + begin * n, colors.stride(), n, count, averages[channel]);
      }
      this->storeColors(pixels.i0 + begin, j, count, averages[0], averages[1], averages[2]);
    }
  }
}

void Film::storeTriangles(const Window& pixels, const std::uint32_t* triangles, int stride) const
{
  const int n = this->Target.samples;
  for (int row = 0; this->Target.triangles && row < pixels.height(); ++row)
  {
    const std::uint32_t* const from =
      triangles + static_cast<std::size_t>(row * n + n / 2) * stride + n / 2;
    std::uint32_t* const to = this->Target.triangles + this->pixel(pixels.i0, pixels.j0 + row);
    for (int i = 0; i < pixels.width(); ++i)
    {
      to[i] = from[i * n];
    }
  }
}
}
