// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief turns samples into pixels: averages, alpha, bytes or floats, the primitives seen
 *
 * With n samples along each axis, a pixel is the sum of its n^2 linear values, divided by n^2 (a
 * box filter). The values are added row by row from the bottom, each row from the left. average()
 * is the definition; AverageKernel.h does the same for many pixels.
 *
 * With alpha, colours are averaged like all values, as colour times alpha, and divided by alpha
 * when they are stored. The film does not depend on what was hit.
 */
#ifndef lambent_Film_h
#define lambent_Film_h

#include "Background.h"
#include "ByteKernel.h"
#include "Image.h"
#include "Scene.h"
#include "TileColors.h"

#include <cstddef>
#include <vector>

namespace lambent
{
/// Colour times alpha, and alpha.
struct FilmColor
{
  Vec3 color;
  double alpha;
};

class Film
{
public:
  Film(const Scene& scene, const Image& image);

  const Image& target() const { return this->Target; }
  const Background& background() const { return this->Behind; }
  /// What a sample of the image's part is if it hits nothing.
  FilmColor missed(int i, int j) const
  {
    return { this->Behind.at(i, j), this->Target.hasAlpha ? 0.0 : 1.0 };
  }

  // Pixels are relative to the image's part. Channels are red, green, blue and, if the image has
  // it, alpha.

  void storeBackground(const Window& pixels) const;
  void storeColor(int i, int j, const FilmColor& color) const;
  /// Stores `count` pixels, at most mostPixels, from (i, j) on. Each channel must hold mostPixels
  /// values.
  static constexpr int mostPixels = mostBytePixels;
  void storeColors(int i, int j, int count, const ChannelSpan& channels) const;
  /// Stores the pixels of a window, whose samples begin in that row of `colors`.
  void storeAverages(const Window& pixels, const TileColors& colors, int row) const;
  /// Stores the primitives of the pixels of a window. `primitives` are those of its samples, in
  /// rows that begin `stride` apart.
  void storePrimitives(const Window& pixels, const std::uint32_t* primitives, int stride) const;

  /// colorOf(i, j): the colour of the sample in that column and row of the pixel.
  template <typename ColorOf>
  static FilmColor average(int samples, const ColorOf& colorOf)
  {
    FilmColor sum = colorOf(0, 0);
    for (int k = 1; k < samples * samples; ++k)
    {
      const FilmColor next = colorOf(k % samples, k / samples);
      sum = { sum.color + next.color, sum.alpha + next.alpha };
    }
    const double count = samples * samples;
    return { divided(sum.color, count), sum.alpha / count };
  }

private:
  /// The pixels of a row without a hit, if all are the same.
  struct RowBackground
  {
    unsigned char bytes[4];
    float floats[4];
  };
  static Vec3 divided(const Vec3& v, double divisor)
  {
    return { v.x / divisor, v.y / divisor, v.z / divisor };
  }
  static FilmColor straight(const FilmColor& color)
  {
    return color.alpha > 0.0 ? FilmColor{ divided(color.color, color.alpha), color.alpha }
                             : FilmColor{ Vec3(0.0), 0.0 };
  }
  FilmColor averageBackground(int i, int j) const;
  void storeStraight(int i, int j, int count, const ChannelSpan& channels) const;
  void storeBackgroundImage(const Window& pixels) const;
  void storeBackgroundImageRow(int begin, int end, int j) const;
  std::size_t pixel(int i, int j) const
  {
    return static_cast<std::size_t>(j) * this->Target.part.width() + i;
  }

  const Image Target;
  const Background Behind;
  std::vector<RowBackground> Rows; ///< unless the background is an image
};
}

#endif
