// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Texture.h"

#include "ColorTable.h"
#include "Elementary.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace lambent
{
namespace
{
constexpr int outside = -1;

/// The pixel of a row or column of `size` pixels that stands for a whole number, which may be NaN
/// or infinite; or `outside`.
int wrapped(double number, int size, TextureWrap wrap)
{
  const double n = size;
  if (number >= 0.0 && number < n)
  {
    return static_cast<int>(number);
  }
  if (wrap == TextureWrap::ClampToBorder)
  {
    return outside;
  }
  if (!std::isfinite(number))
  {
    return 0;
  }
  if (wrap == TextureWrap::ClampToEdge)
  {
    return number < 0.0 ? 0 : size - 1;
  }
  const bool isMirrored = wrap == TextureWrap::MirroredRepeat;
  const double period = isMirrored ? 2.0 * n : n;
  double place = std::fmod(number, period); // exact
  place = place < 0.0 ? place + period : place;
  return static_cast<int>(place < n ? place : period - 1.0 - place);
}

/// Two neighbouring pixels of a row or column, and how far a place is from the first to the second.
struct Neighbors
{
  int first, second;
  double fraction;

  Neighbors(double place, int size, TextureWrap wrap)
  {
    const double low = std::floor(place);
    this->first = wrapped(low, size, wrap);
    this->second = wrapped(low + 1.0, size, wrap);
    this->fraction = std::isfinite(place) ? place - low : 0.0;
  }
};

TextureColor between(const TextureColor& a, const TextureColor& b, double fraction)
{
  return { a.color + (b.color - a.color) * fraction, a.alpha + (b.alpha - a.alpha) * fraction };
}

/// The linear values of all bytes, which are computed once.
const double* byteValues(bool areSRGB)
{
  struct Values
  {
    double plain[256], decoded[256];
    Values()
    {
      for (int k = 0; k < 256; ++k)
      {
        const double x = channelOf(static_cast<unsigned char>(k));
        this->plain[k] = x;
        this->decoded[k] = x <= 0.04045 ? x / 12.92 : power((x + 0.055) / 1.055, 2.4);
      }
    }
  };
  static const Values values;
  return areSRGB ? values.decoded : values.plain;
}

/// A texture whose pixels have a known type.
template <typename Value>
class Sampler
{
public:
  Sampler(const Texture& texture, const Value* pixels)
    : Image(texture)
    , Pixels(pixels)
    , Bytes(byteValues(texture.isSRGB))
  {
  }

  TextureColor nearest(double s, double t) const
  {
    const Texture& image = this->Image;
    return this->pixel(wrapped(std::floor(s * image.width), image.width, image.wrap),
      wrapped(std::floor(t * image.height), image.height, image.wrap));
  }

  TextureColor interpolated(double s, double t) const
  {
    const Texture& image = this->Image;
    const Neighbors columns(s * image.width - 0.5, image.width, image.wrap);
    const Neighbors rows(t * image.height - 0.5, image.height, image.wrap);
    const auto inRow = [&](int row)
    {
      return between(
        this->pixel(columns.first, row), this->pixel(columns.second, row), columns.fraction);
    };
    return between(inRow(rows.first), inRow(rows.second), rows.fraction);
  }

private:
  static double linear(float value) { return static_cast<double>(value); }
  static double linear(std::uint16_t value) { return value / 65535.0; }
  static double linear(std::uint8_t value) { return channelOf(value); }
  double channel(Value value) const
  {
    if constexpr (sizeof(Value) == 1)
    {
      return this->Bytes[value];
    }
    return linear(value);
  }

  TextureColor pixel(int i, int j) const
  {
    if (i == outside || j == outside)
    {
      return this->Image.border;
    }
    const int count = this->Image.pixels.components;
    const Value* const values = this->Pixels +
      (static_cast<std::size_t>(j) * this->Image.width + static_cast<std::size_t>(i)) * count;
    const double red = this->channel(values[0]);
    const bool isGrey = count < 3;
    return { { red, isGrey ? red : this->channel(values[1]),
               isGrey ? red : this->channel(values[2]) },
      count % 2 == 0 ? linear(values[count - 1]) : 1.0 };
  }

  const Texture& Image;
  const Value* const Pixels;
  const double* const Bytes; ///< the values of bytes of colours
};

template <typename Value>
TextureColor sampleIn(const Texture& texture, double s, double t)
{
  const Sampler<Value> sampler(texture, static_cast<const Value*>(texture.pixels.data));
  return texture.isInterpolated ? sampler.interpolated(s, t) : sampler.nearest(s, t);
}
}

TextureColor Texture::sample(double u, double v) const
{
  const auto row = [&](const double* m) { return (m[0] * u + m[1] * v) + m[2]; };
  const double s = row(this->matrix[0]), t = row(this->matrix[1]);
  switch (this->pixels.type)
  {
    case AttributeType::UInt8:
      return sampleIn<std::uint8_t>(*this, s, t);
    case AttributeType::UInt16:
      return sampleIn<std::uint16_t>(*this, s, t);
    default:
      return sampleIn<float>(*this, s, t);
  }
}

bool Texture::isAnyTransparent() const
{
  const auto components = static_cast<std::size_t>(this->pixels.components);
  const auto count = static_cast<std::size_t>(this->width) * static_cast<std::size_t>(this->height);
  const double opaque = this->pixels.type == AttributeType::UInt8 ? 255.0
    : this->pixels.type == AttributeType::UInt16                  ? 65535.0
                                                                  : 1.0;
  return components % 2 == 0 &&
    this->pixels.visit(
      [&](const auto* all)
      {
        bool isAny = false;
        for (std::size_t k = 1; k <= count; ++k)
        {
          isAny = isAny || static_cast<double>(all[k * components - 1]) != opaque;
        }
        return isAny;
      });
}

double decodeSRGB(unsigned char byte)
{
  return byteValues(true)[byte];
}
}
