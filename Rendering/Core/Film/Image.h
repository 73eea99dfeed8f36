// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the memory that an image is written to
 */
#ifndef lambent_Image_h
#define lambent_Image_h

#include "Window.h"

#include <cstdint>

namespace lambent
{
/**
 * The destination of an image or a part of it: rows from the bottom, three channels per pixel, as
 * bytes or floats (the other one is nullptr). If `triangles` is set, it receives the number of the
 * triangle that each pixel shows, as counted by SceneMesh, or noTriangle.
 *
 * With n samples along each axis, a pixel is the average of n x n pixels of the image of size n
 * width x n height. Its triangle is that of sample (n / 2, n / 2), rounded down.
 */
struct Image
{
  int width = 0, height = 0; ///< of the whole image
  Window part;               ///< the part that is rendered and stored
  int samples = 1;           ///< n, at least 1
  unsigned char* bytes = nullptr;
  float* floats = nullptr;
  std::uint32_t* triangles = nullptr;

  /// The part, in samples.
  Window samplePart() const
  {
    return { this->part.i0 * this->samples, this->part.i1 * this->samples,
      this->part.j0 * this->samples, this->part.j1 * this->samples };
  }
};
}

#endif
