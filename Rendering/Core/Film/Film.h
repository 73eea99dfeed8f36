// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief write pixels: colours as bytes or floats, the background, the triangles seen
 *
 * The film is told the colour of each sample and does not ask what was hit.
 */
#ifndef lambent_Film_h
#define lambent_Film_h

#include "Image.h"
#include "Scene.h"

#include <cstddef>
#include <vector>

namespace lambent
{
class Film
{
public:
  Film(const Scene& scene, const Image& image);

  const Image& target() const { return this->Target; }

  /// In a row of the image's part.
  const Vec3& background(int j) const { return this->Backgrounds[j].color; }

  // Pixels count from the image's part.
  void storeBackground(const Window& pixels) const;
  void storeColor(int i, int j, const Vec3& color) const;
  /// Of `count` pixels, at most 32, from (i, j) on; there must be 32 values a channel.
  void storeColors(
    int i, int j, int count, const double* red, const double* green, const double* blue) const;
  /// Of the pixels of a window, whose rows begin `stride` apart.
  void storeTriangles(const Window& pixels, const std::uint32_t* triangles, int stride) const;

private:
  /// As it is and as it is stored.
  struct Background
  {
    Vec3 color;
    unsigned char bytes[3];
    float floats[3];
  };
  Background backgroundOf(const Scene& scene, int j) const;
  std::size_t pixel(int i, int j) const
  {
    return static_cast<std::size_t>(j) * this->Target.part.width() + i;
  }

  const Image Target;
  std::vector<Background> Backgrounds; ///< of each row of the part
};
}

#endif
