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
/// Interpolates. If the fraction is 0, the result is exactly the first colour, even if the second
/// is infinite or NaN.
Vec3 mixed(const Vec3& first, const Vec3& second, double fraction)
{
  return fraction == 0.0 ? first : first + (second - first) * fraction;
}
}

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
  const auto value = [&](int component)
  {
    const double stored = pixels.at(number, component);
    return pixels.type == AttributeType::UInt8 ? stored / 255.0 : stored;
  };
  const bool isGrey = pixels.components < 3;
  const Vec3 color(value(0), value(isGrey ? 0 : 1), value(isGrey ? 0 : 2));
  if (pixels.components % 2 == 1)
  {
    return color;
  }
  const double alpha = value(pixels.components - 1);
  return color * alpha + base * (1.0 - alpha);
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
    return mixed(this->pixel(columns.first, row, base), this->pixel(columns.second, row, base),
      columns.fraction);
  };
  return mixed(inRow(rows.first), inRow(rows.second), rows.fraction);
}

void Background::fill(int i, int j, int count, double* const* channels) const
{
  for (int channel = 0; !this->hasImage() && channel < 3; ++channel)
  {
    std::fill_n(channels[channel], count, this->Gradient[j][channel]);
  }
  for (int k = 0; this->hasImage() && k < count; ++k)
  {
    const Vec3 color = this->at(i + k, j);
    for (int channel = 0; channel < 3; ++channel)
    {
      channels[channel][k] = color[channel];
    }
  }
}
}
