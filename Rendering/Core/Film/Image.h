// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the memory that an image is written to
 */
#ifndef lambent_Image_h
#define lambent_Image_h

#include "Window.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent
{
/// What is stored beside the colours.
enum class PassContent
{
  Depth,    ///< the distance along the viewing direction
  Normal,   ///< the unit normal, in the world, on the side that is lit
  Position, ///< in the world
  Attribute ///< an attribute of the surface
};

/// Data of the surface that each pixel shows: floats or doubles, so many components per pixel. NaN
/// where nothing is hit, and where the surface does not have the attribute.
struct Pass
{
  PassContent content = PassContent::Depth;
  int components = 1;
  bool isDouble = false;
  void* data = nullptr;
  std::size_t attribute = 0; ///< its index in Surface::attributes
};

/**
 * The destination of an image or a part of it: rows from the bottom, three channels per pixel, as
 * bytes or floats (the other one is nullptr). If `primitives` is set, it receives the number of the
 * primitive that each pixel shows, as counted by SceneMesh, or noPrimitive.
 *
 * With n samples along each axis, a pixel is the average of n x n pixels of the image of size n
 * width x n height. Its primitive and its passes are those of sample (n / 2, n / 2), rounded down.
 *
 * If the image has alpha, there is a fourth channel: the fraction of the samples that hit
 * something. The colour is the average of these samples only, and 0 if there are none (straight
 * alpha). There is no background.
 */
struct Image
{
  int width = 0, height = 0; ///< of the whole image
  Window part;               ///< the part that is rendered and stored
  int samples = 1;           ///< n, at least 1
  bool hasAlpha = false;
  unsigned char* bytes = nullptr;
  float* floats = nullptr;
  std::uint32_t* primitives = nullptr;
  std::vector<Pass> passes;

  int channels() const { return this->hasAlpha ? 4 : 3; }

  /// Some rows of the part, from j0 to j1 - 1.
  Image rows(int j0, int j1) const
  {
    Image result = *this;
    result.part.j0 = j0;
    result.part.j1 = j1;
    const std::size_t before =
      static_cast<std::size_t>(j0 - this->part.j0) * this->part.width(); // pixels
    result.bytes += this->bytes ? before * this->channels() : 0;
    result.floats += this->floats ? before * this->channels() : 0;
    result.primitives += this->primitives ? before : 0;
    for (Pass& pass : result.passes)
    {
      const std::size_t size = pass.isDouble ? sizeof(double) : sizeof(float);
      pass.data = static_cast<char*>(pass.data) + before * pass.components * size;
    }
    return result;
  }

  /// The pixels that a window of samples is made of.
  Window pixelsOf(const Window& window) const
  {
    return { window.i0 / this->samples, window.i1 / this->samples, window.j0 / this->samples,
      window.j1 / this->samples };
  }

  /// The part, in samples.
  Window samplePart() const
  {
    return { this->part.i0 * this->samples, this->part.i1 * this->samples,
      this->part.j0 * this->samples, this->part.j1 * this->samples };
  }
};
}

#endif
