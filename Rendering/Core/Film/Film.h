// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief turns samples into pixels: averages, bytes or floats, the background, the triangles seen
 *
 * With n samples along each axis, a pixel is the sum of its n^2 linear values, divided by n^2 (a
 * box filter). The values are added row by row from the bottom, each row from the left. average()
 * is the definition; AverageKernel.h does the same for many pixels. The film does not depend on
 * what was hit.
 */
#ifndef lambent_Film_h
#define lambent_Film_h

#include "Image.h"
#include "Scene.h"
#include "TileColors.h"

#include <cstddef>
#include <vector>

namespace lambent
{
class Film
{
public:
  Film(const Scene& scene, const Image& image);

  const Image& target() const { return this->Target; }

  /// The background of a row of samples in the image's part.
  const Vec3& background(int j) const { return this->SampleBackgrounds[j]; }

  // Pixels are relative to the image's part.
  void storeBackground(const Window& pixels) const;
  void storeColor(int i, int j, const Vec3& color) const;
  /// Stores `count` pixels, at most 32, from (i, j) on. Each channel must hold 32 values.
  void storeColors(
    int i, int j, int count, const double* red, const double* green, const double* blue) const;
  /// Stores the pixels of a window, whose samples begin in that row of `colors`.
  void storeAverages(const Window& pixels, const TileColors& colors, int row) const;
  /// Stores the triangles of the pixels of a window. `triangles` are those of its samples, in rows
  /// that begin `stride` apart.
  void storeTriangles(const Window& pixels, const std::uint32_t* triangles, int stride) const;

  /// colorOf(i, j): the colour of the sample in that column and row of the pixel.
  template <typename ColorOf>
  static Vec3 average(int samples, const ColorOf& colorOf)
  {
    Vec3 sum = colorOf(0, 0);
    for (int k = 1; k < samples * samples; ++k)
    {
      sum = sum + colorOf(k % samples, k / samples);
    }
    const double count = samples * samples;
    return { sum.x / count, sum.y / count, sum.z / count };
  }

private:
  /// The background, and its bytes and floats.
  struct Background
  {
    Vec3 color;
    unsigned char bytes[3];
    float floats[3];
  };
  Background backgroundOf(int j) const;
  std::size_t pixel(int i, int j) const
  {
    return static_cast<std::size_t>(j) * this->Target.part.width() + i;
  }

  const Image Target;
  std::vector<Vec3> SampleBackgrounds; ///< one per row of samples of the part
  std::vector<Background> Backgrounds; ///< one per row of pixels
};
}

#endif
