// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The colour of a texture at a place, compared with whole-number wrapping and 80-bit arithmetic.
#include "RandomNumbers.h"
#include "Texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

using namespace lambent;

namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
const TextureWrap wraps[] = { TextureWrap::ClampToEdge, TextureWrap::Repeat,
  TextureWrap::MirroredRepeat, TextureWrap::ClampToBorder };

/// A texture of random pixels, whose linear values are kept.
struct RandomTexture
{
  Texture texture;
  std::vector<unsigned char> memory;
  std::vector<long double> values; ///< RGBA of each pixel

  RandomTexture(RandomNumbers& random, int width, int height, int components, AttributeType type)
  {
    this->texture.width = width;
    this->texture.height = height;
    const auto count = static_cast<std::size_t>(width) * height * components;
    std::vector<long double> linear;
    for (std::size_t k = 0; k < count; ++k)
    {
      const auto bits = static_cast<std::uint16_t>(random.below(65536));
      const auto byte = static_cast<unsigned char>(bits >> 8);
      const float number = 3.0f * bits / 65536.0f - 1.0f;
      const auto append = [this](const auto& value)
      {
        const auto* const bytes = reinterpret_cast<const unsigned char*>(&value);
        this->memory.insert(this->memory.end(), bytes, bytes + sizeof(value));
      };
      type == AttributeType::UInt8      ? append(byte)
        : type == AttributeType::UInt16 ? append(bits)
                                        : append(number);
      linear.push_back(type == AttributeType::UInt8 ? byte / 255.0L
          : type == AttributeType::UInt16           ? bits / 65535.0L
                                                    : static_cast<long double>(number));
    }
    for (std::size_t k = 0; k < count; k += components)
    {
      const bool isGrey = components < 3;
      this->values.insert(this->values.end(),
        { linear[k], linear[k + (isGrey ? 0 : 1)], linear[k + (isGrey ? 0 : 2)],
          components % 2 == 0 ? linear[k + components - 1] : 1.0L });
    }
    this->texture.pixels = { this->memory.data(), type, components, false };
    this->texture.border = { { 0.25, 0.5, 0.75 }, 0.125 };
  }

  static std::int64_t remainder(std::int64_t k, std::int64_t n) { return (k % n + n) % n; }

  /// -1 means the border.
  std::int64_t wrapped(std::int64_t k, std::int64_t n) const
  {
    switch (this->texture.wrap)
    {
      case TextureWrap::ClampToEdge:
        return k < 0 ? 0 : k >= n ? n - 1 : k;
      case TextureWrap::Repeat:
        return remainder(k, n);
      case TextureWrap::MirroredRepeat:
        return remainder(k, 2 * n) < n ? remainder(k, n) : n - 1 - remainder(k, n);
      default:
        return k < 0 || k >= n ? -1 : k;
    }
  }

  long double pixel(std::int64_t i, std::int64_t j, int channel) const
  {
    const TextureColor& border = this->texture.border;
    i = this->wrapped(i, this->texture.width);
    j = this->wrapped(j, this->texture.height);
    return i < 0 || j < 0
      ? static_cast<long double>(channel < 3 ? border.color[channel] : border.alpha)
      : this->values[4 * (j * this->texture.width + i) + channel];
  }

  long double expected(double s, double t, int channel) const
  {
    long double x = static_cast<long double>(s) * this->texture.width;
    long double y = static_cast<long double>(t) * this->texture.height;
    if (!this->texture.isInterpolated)
    {
      return this->pixel(std::llround(std::floor(x)), std::llround(std::floor(y)), channel);
    }
    x -= 0.5L;
    y -= 0.5L;
    const std::int64_t i = std::llround(std::floor(x)), j = std::llround(std::floor(y));
    const long double a = x - i, b = y - j;
    return (this->pixel(i, j, channel) * (1 - a) + this->pixel(i + 1, j, channel) * a) * (1 - b) +
      (this->pixel(i, j + 1, channel) * (1 - a) + this->pixel(i + 1, j + 1, channel) * a) * b;
  }
};

double channelOfColor(const TextureColor& color, int channel)
{
  return channel < 3 ? color.color[channel] : color.alpha;
}

void expectSame(const TextureColor& a, const TextureColor& b)
{
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.alpha, b.alpha);
}

/// Compares at random places, some of them far away; multiples of 1/8 of a pixel are exact.
void compare(RandomNumbers& random, const RandomTexture& image)
{
  const double tolerance = image.texture.isInterpolated ? 1e-13 : 1e-15;
  for (int k = 0; k < 200; ++k)
  {
    const int reach = k % 4 == 0 ? 1000 : 3;
    const auto place = [&](int size)
    {
      const int pixels = random.below(2 * reach * size * 8) - reach * size * 8;
      return (pixels + 0.5) / 8.0 / size; // not on the edge of a pixel
    };
    const double s = place(image.texture.width), t = place(image.texture.height);
    const TextureColor found = image.texture.sample(s, t);
    for (int channel = 0; channel < 4; ++channel)
    {
      ASSERT_NEAR(channelOfColor(found, channel),
        static_cast<double>(image.expected(s, t, channel)), tolerance * reach)
        << s << " " << t << ", channel " << channel;
    }
  }
}
}

TEST(Texture, WrapsAndFilters)
{
  RandomNumbers random(1);
  for (const AttributeType type :
    { AttributeType::UInt8, AttributeType::UInt16, AttributeType::Float })
  {
    for (int components = 1; components <= 4; ++components)
    {
      for (const auto& size : { std::pair(1, 1), std::pair(5, 1), std::pair(4, 7) })
      {
        RandomTexture image(random, size.first, size.second, components, type);
        for (const TextureWrap wrap : wraps)
        {
          for (const bool isInterpolated : { false, true })
          {
            image.texture.wrap = wrap;
            image.texture.isInterpolated = isInterpolated;
            compare(random, image);
          }
        }
      }
    }
  }
}

// No multiplication by 1 - x and x, whose sum may differ from 1 after rounding.
TEST(Texture, KeepsOneColour)
{
  const float color[3] = { 0.1f, 0.7f, 1.0f / 3.0f };
  std::vector<float> pixels;
  for (int k = 0; k < 6; ++k)
  {
    pixels.insert(pixels.end(), color, color + 3);
  }
  Texture texture;
  texture.pixels = { pixels.data(), AttributeType::Float, 3, false };
  texture.width = 3;
  texture.height = 2;
  texture.isInterpolated = true;
  RandomNumbers random(2);
  for (int k = 0; k < 1000; ++k)
  {
    const TextureColor found = texture.sample(random.within(-4.0, 4.0), random.within(-4.0, 4.0));
    expectSame(found, { Vec3(color[0], color[1], color[2]), 1.0 });
  }
}

TEST(Texture, MiddlesOfPixelsAreExact)
{
  RandomNumbers random(3);
  RandomTexture image(random, 8, 4, 4, AttributeType::UInt8);
  for (const bool isInterpolated : { false, true })
  {
    image.texture.isInterpolated = isInterpolated;
    for (int j = 0; j < 4; ++j)
    {
      for (int i = 0; i < 8; ++i)
      {
        const unsigned char* const bytes = &image.memory[4 * (8 * j + i)];
        expectSame(image.texture.sample((i + 0.5) / 8, (j + 0.5) / 4),
          { Vec3(bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0), bytes[3] / 255.0 });
      }
    }
  }
}

TEST(Texture, CoordinatesThatAreNotFinite)
{
  RandomNumbers random(4);
  RandomTexture image(random, 5, 3, 4, AttributeType::UInt8);
  const Texture& texture = image.texture;
  for (const TextureWrap wrap : wraps)
  {
    for (const bool isInterpolated : { false, true })
    {
      image.texture.wrap = wrap;
      image.texture.isInterpolated = isInterpolated;
      const bool hasBorder = wrap == TextureWrap::ClampToBorder;
      for (const double bad : { notANumber, infinity, -infinity, 1e308, -1e308 })
      {
        const bool isFar = std::abs(bad) == 1e308 && wrap == TextureWrap::ClampToEdge;
        const double middle = 0.5 / 3; // of the first row
        // 1e308 becomes infinite in a texture of 5 pixels.
        SCOPED_TRACE(bad);
        expectSame(texture.sample(bad, middle),
          hasBorder ? texture.border : texture.sample(0.5 / 5, middle));
        if (!isFar)
        {
          expectSame(
            texture.sample(bad, bad), hasBorder ? texture.border : texture.sample(0.5 / 5, middle));
        }
      }
    }
  }
}

// Coordinates whose fraction is lost in a double, but which are finite.
TEST(Texture, CoordinatesThatAreHuge)
{
  RandomNumbers random(5);
  RandomTexture image(random, 5, 3, 1, AttributeType::UInt8);
  for (const TextureWrap wrap : wraps)
  {
    image.texture.wrap = wrap;
    for (const double huge : { 1e17, -1e17, 1e300, -1e300 })
    {
      const double found = image.texture.sample(huge, -huge).color.x;
      EXPECT_GE(found, 0.0);
      EXPECT_LE(found, 1.0);
    }
  }
}

TEST(Texture, SRGB)
{
  for (int byte = 0; byte < 256; ++byte)
  {
    const long double x = byte / 255.0L;
    const long double expected = x <= 0.04045L ? x / 12.92L : std::pow((x + 0.055L) / 1.055L, 2.4L);
    EXPECT_NEAR(decodeSRGB(static_cast<unsigned char>(byte)), static_cast<double>(expected), 1e-15);
  }
  EXPECT_EQ(decodeSRGB(0), 0.0);
  EXPECT_EQ(decodeSRGB(255), 1.0);
  // Decoded before interpolation, but not alpha, and no other type.
  const unsigned char pixels[4] = { 0, 128, 255, 64 };
  Texture texture;
  texture.pixels = { pixels, AttributeType::UInt8, 2, false };
  texture.width = 2;
  texture.height = 1;
  texture.isInterpolated = texture.isSRGB = true;
  expectSame(texture.sample(0.5, 0.5), { Vec3(0.5), (128 / 255.0 + 64 / 255.0) / 2 });
  const float number = 0.25f;
  texture.pixels = { &number, AttributeType::Float, 1, false };
  texture.width = 1;
  EXPECT_EQ(texture.sample(0.0, 0.0).color.x, 0.25);
}

TEST(Texture, Matrix)
{
  RandomNumbers random(6);
  RandomTexture image(random, 8, 4, 3, AttributeType::UInt8);
  RandomTexture moved = image;
  moved.texture.pixels.data = moved.memory.data();
  const double matrix[2][3] = { { 0.5, -2.0, 0.25 }, { 1.0, 4.0, -0.125 } };
  std::memcpy(moved.texture.matrix, matrix, sizeof(matrix));
  for (int k = 0; k < 100; ++k)
  {
    const double u = random.below(64) / 16.0 + 1.0 / 64, v = random.below(64) / 16.0 + 1.0 / 128;
    expectSame(moved.texture.sample(u, v),
      image.texture.sample(0.5 * u - 2.0 * v + 0.25, u + 4.0 * v - 0.125));
  }
}
