// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Background.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lambent
{
namespace
{
/// The number of samples that fill() computes at a time, and the largest number of pixels that it
/// reads for them.
constexpr int mostSamples = 64, mostPixels = 72;

/// Interpolates. If the fraction is 0, the result is exactly the first colour, even if the second
/// is infinite or NaN, and second() is not called.
template <typename Second>
Vec3 mixed(const Vec3& first, const Second& second, double fraction)
{
  return fraction == 0.0 ? first : first + (second() - first) * fraction;
}

double fromByte(double stored)
{
  return stored / 255.0;
}

/// The colour of a pixel composited over the colour `base`. value(k): the pixel's component k.
template <typename ValueOf>
Vec3 composited(const ValueOf& value, int components, const Vec3& base)
{
  const bool isGrey = components < 3;
  const Vec3 color(value(0), value(isGrey ? 0 : 1), value(isGrey ? 0 : 2));
  if (components % 2 == 1)
  {
    return color;
  }
  const double alpha = value(components - 1);
  return alpha == 0.0 ? base : color * alpha + base * (1.0 - alpha);
}
}

/// Pixels of a row of the image, by channel.
struct Background::PixelRow
{
  double channels[3][mostPixels];

  void set(int k, const Vec3& color)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      this->channels[channel][k] = color[channel];
    }
  }
};

Background::Background(const Scene& scene, const Image& image)
{
  const Window part = image.samplePart();
  const int width = image.width * image.samples, height = image.height * image.samples;
  for (int j = part.j0; j < part.j1; ++j)
  {
    this->Gradient.push_back(image.hasAlpha
        ? Vec3(0.0)
        : scene.background + (scene.backgroundTop - scene.background) * ((j + 0.5) / height));
  }
  if (scene.backgroundImage.pixels && !image.hasAlpha)
  {
    this->Behind = scene.backgroundImage;
    this->Columns = neighbours(part.i0, part.i1, width, this->Behind.width);
    this->Rows = neighbours(part.j0, part.j1, height, this->Behind.height);
    for (int stored = 0; stored < 256; ++stored)
    {
      this->FromByte.push_back(fromByte(stored));
    }
  }
}

/// For the samples [begin, end) along an axis of the picture, finds the pixels of the image that
/// each is interpolated between. The axis has `samples` samples and `pixels` pixels.
std::vector<Background::Neighbours> Background::neighbours(
  int begin, int end, int samples, int pixels)
{
  std::vector<Neighbours> result;
  for (int k = begin; k < end; ++k)
  {
    const double last = pixels - 1.0;
    const double x = std::clamp((k + 0.5) * pixels / samples - 0.5, 0.0, last);
    const double first = std::floor(x);
    result.push_back(
      { static_cast<int>(first), static_cast<int>(std::min(first + 1.0, last)), x - first });
  }
  return result;
}

/// The colour of a pixel of the image, composited over the colour `base`.
Vec3 Background::pixel(int column, int row, const Vec3& base) const
{
  const AttributeSpan& pixels = this->Behind.pixels;
  const std::size_t number = static_cast<std::size_t>(row) * this->Behind.width + column;
  return composited(
    [&](int component)
    {
      const double stored = pixels.at(number, component);
      return pixels.type == AttributeType::UInt8 ? fromByte(stored) : stored;
    },
    pixels.components, base);
}

Vec3 Background::at(int i, int j) const
{
  const Vec3& base = this->Gradient[j];
  if (!this->hasImage())
  {
    return base;
  }
  const Neighbours& columns = this->Columns[i];
  const Neighbours& rows = this->Rows[j];
  const auto inRow = [&](int row)
  {
    return mixed(
      this->pixel(columns.first, row, base),
      [&]() { return this->pixel(columns.second, row, base); }, columns.fraction);
  };
  return mixed(
    inRow(rows.first), [&]() { return inRow(rows.second); }, rows.fraction);
}

void Background::fill(int i, int j, int count, double* const* channels) const
{
  if (!this->hasImage())
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      std::fill_n(channels[channel], count, this->Gradient[j][channel]);
    }
    return;
  }
  for (int done = 0, next = 0; done < count; done += next)
  {
    next = std::min(count - done, mostSamples);
    const int last = this->Columns[i + done + next - 1].second;
    if (last - this->Columns[i + done].first >= mostPixels)
    {
      next = 1; // the image is larger than the picture, and most of its pixels are not needed
    }
    double* const to[3] = { channels[0] + done, channels[1] + done, channels[2] + done };
    this->fillFew(i + done, j, next, to);
  }
}

/// Does the same as at(), in the same order, but reads each pixel once.
void Background::fillFew(int i, int j, int count, double* const* channels) const
{
  const Neighbours& rows = this->Rows[j];
  const Neighbours* const columns = this->Columns.data() + i;
  const int first = columns[0].first, pixels = columns[count - 1].second + 1 - first;
  const auto interpolate = [&](int row, double* const* to)
  {
    PixelRow from;
    this->read(first, row, pixels, this->Gradient[j], from);
    for (int channel = 0; channel < 3; ++channel)
    {
      const double* const values = from.channels[channel];
      for (int k = 0; k < count; ++k)
      {
        const double a = values[columns[k].first - first], b = values[columns[k].second - first];
        to[channel][k] = columns[k].fraction == 0.0 ? a : a + (b - a) * columns[k].fraction;
      }
    }
  };
  interpolate(rows.first, channels);
  if (rows.fraction != 0.0)
  {
    double second[3][mostSamples];
    double* const to[3] = { second[0], second[1], second[2] };
    interpolate(rows.second, to);
    for (int channel = 0; channel < 3; ++channel)
    {
      for (int k = 0; k < count; ++k)
      {
        const double a = channels[channel][k], b = second[channel][k];
        channels[channel][k] = a + (b - a) * rows.fraction;
      }
    }
  }
}

/// Reads `count` pixels of a row of the image, from `column` on.
void Background::read(int column, int row, int count, const Vec3& base, PixelRow& to) const
{
  const AttributeSpan& pixels = this->Behind.pixels;
  const int components = pixels.components;
  const std::size_t begin =
    (static_cast<std::size_t>(row) * this->Behind.width + column) * components;
  if (pixels.type == AttributeType::UInt8)
  {
    const unsigned char* bytes = static_cast<const unsigned char*>(pixels.data) + begin;
    for (int k = 0; k < count; ++k, bytes += components)
    {
      to.set(k, composited([&](int c) { return this->FromByte[bytes[c]]; }, components, base));
    }
    return;
  }
  if (pixels.type == AttributeType::Float)
  {
    const float* floats = static_cast<const float*>(pixels.data) + begin;
    for (int k = 0; k < count; ++k, floats += components)
    {
      to.set(
        k, composited([&](int c) { return static_cast<double>(floats[c]); }, components, base));
    }
    return;
  }
  for (int k = 0; k < count; ++k)
  {
    to.set(k, this->pixel(column + k, row, base));
  }
}
}
