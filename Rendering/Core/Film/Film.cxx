// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Film.h"

#include "AverageKernel.h"
#include "ImageContract.h"

#include <algorithm>
#include <cstring>

namespace lambent
{
namespace
{
/// Writes a pixel `count` times.
template <typename Channel>
void repeat(const Channel* pixel, int channels, int count, Channel* out)
{
  // Compare bits: 0 equals -0, but has other bits.
  if (std::memcmp(pixel, pixel + 1, (channels - 1) * sizeof(Channel)) == 0)
  {
    std::fill_n(out, channels * count, pixel[0]);
    return;
  }
  for (int i = 0; i < count; ++i)
  {
    std::copy_n(pixel, channels, out + channels * i);
  }
}
}

Film::Film(const Scene& scene, const Image& image)
  : Target(image)
  , Behind(scene, image)
{
  for (int j = 0; !this->Behind.hasImage() && j < image.part.height(); ++j)
  {
    const FilmColor color = this->averageBackground(0, j);
    RowBackground row{};
    for (int channel = 0; channel < image.channels(); ++channel)
    {
      const double value = channel < 3 ? color.color[channel] : color.alpha;
      row.bytes[channel] = toByte(value);
      row.floats[channel] = toFloat(value);
    }
    this->Rows.push_back(row);
  }
}

/// The background of a pixel.
FilmColor Film::averageBackground(int i, int j) const
{
  const int n = this->Target.samples;
  return average(n, [&](int column, int row) { return this->missed(n * i + column, n * j + row); });
}

void Film::storeBackground(const Window& pixels) const
{
  const int channels = this->Target.channels();
  for (int j = pixels.j0; j < pixels.j1; ++j)
  {
    const std::size_t first = this->pixel(pixels.i0, j);
    if (this->Target.primitives)
    {
      std::fill_n(this->Target.primitives + first, pixels.width(), noPrimitive);
    }
    if (this->Behind.hasImage())
    {
      continue;
    }
    const RowBackground& row = this->Rows[j];
    if (this->Target.bytes)
    {
      repeat(row.bytes, channels, pixels.width(), this->Target.bytes + channels * first);
    }
    else
    {
      repeat(row.floats, channels, pixels.width(), this->Target.floats + channels * first);
    }
  }
  if (this->Behind.hasImage())
  {
    this->storeBackgroundImage(pixels);
  }
}

void Film::storeBackgroundImage(const Window& pixels) const
{
  const int n = this->Target.samples;
  TileColors colors;
  if (n > 1)
  {
    colors.reset(n * pixels.width(), n, 3);
  }
  for (int j = pixels.j0; j < pixels.j1; ++j)
  {
    for (int row = 0; n > 1 && row < n; ++row)
    {
      double* const channels[3] = { colors.at(0, 0, row), colors.at(1, 0, row),
        colors.at(2, 0, row) };
      this->Behind.fill(n * pixels.i0, n * j + row, n * pixels.width(), channels);
    }
    n == 1 ? this->storeBackgroundImageRow(pixels.i0, pixels.i1, j)
           : this->storeAverages({ pixels.i0, pixels.i1, j, j + 1 }, colors, 0);
  }
}

/// Each sample is a pixel.
void Film::storeBackgroundImageRow(int begin, int end, int j) const
{
  double colors[4][mostPixels] = {};
  double* const channels[3] = { colors[0], colors[1], colors[2] };
  for (int i = begin; i < end; i += mostPixels)
  {
    const int count = std::min(mostPixels, end - i);
    this->Behind.fill(i, j, count, channels);
    this->storeColors(i, j, count, { colors[0], mostPixels });
  }
}

void Film::storeColor(int i, int j, const FilmColor& color) const
{
  const int channels = this->Target.channels();
  const FilmColor stored = this->Target.hasAlpha ? straight(color) : color;
  const std::size_t first = channels * this->pixel(i, j);
  for (int channel = 0; channel < channels; ++channel)
  {
    const double value = channel < 3 ? stored.color[channel] : stored.alpha;
    if (this->Target.bytes)
    {
      this->Target.bytes[first + channel] = toByte(value);
    }
    else
    {
      this->Target.floats[first + channel] = toFloat(value);
    }
  }
}

void Film::storeColors(int i, int j, int count, const ChannelSpan& channels) const
{
  if (!this->Target.hasAlpha)
  {
    this->storeStraight(i, j, count, channels);
    return;
  }
  double colors[4][mostPixels];
  for (int k = 0; k < mostPixels; ++k)
  {
    const double alpha = channels[3][k];
    for (int channel = 0; channel < 3; ++channel)
    {
      colors[channel][k] = alpha > 0.0 ? channels[channel][k] / alpha : 0.0;
    }
    colors[3][k] = alpha;
  }
  this->storeStraight(i, j, count, { colors[0], mostPixels });
}

/// Colours are not multiplied by alpha.
void Film::storeStraight(int i, int j, int count, const ChannelSpan& channels) const
{
  const int channelCount = this->Target.channels();
  const std::size_t first = channelCount * this->pixel(i, j);
  if (this->Target.bytes)
  {
    storeBytes(channels, channelCount, count, this->Target.bytes + first);
    return;
  }
  float* out = this->Target.floats + first;
  for (int k = 0; k < count; ++k)
  {
    for (int channel = 0; channel < channelCount; ++channel)
    {
      *out++ = toFloat(channels[channel][k]);
    }
  }
}

void Film::storeAverages(const Window& pixels, const TileColors& colors, int row) const
{
  constexpr int room = mostPixels + 8;
  double averages[4][room] = {};
  const int n = this->Target.samples;
  for (int j = pixels.j0; j < pixels.j1; ++j, row += n)
  {
    for (int begin = 0; begin < pixels.width(); begin += mostPixels)
    {
      const int count = std::min(mostPixels, pixels.width() - begin);
      for (int channel = 0; channel < this->Target.channels(); ++channel)
      {
        averageSamples(
          colors.row(channel, row) + begin * n, colors.stride(), n, count, averages[channel]);
      }
      this->storeColors(pixels.i0 + begin, j, count, { averages[0], room });
    }
  }
}

void Film::storePrimitives(const Window& pixels, const std::uint32_t* primitives, int stride) const
{
  const int n = this->Target.samples;
  for (int row = 0; this->Target.primitives && row < pixels.height(); ++row)
  {
    const std::uint32_t* const from =
      primitives + static_cast<std::size_t>(row * n + n / 2) * stride + n / 2;
    std::uint32_t* const to = this->Target.primitives + this->pixel(pixels.i0, pixels.j0 + row);
    for (int i = 0; i < pixels.width(); ++i)
    {
      to[i] = from[i * n];
    }
  }
}
}
