// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief where a picture is written
 */
#ifndef lambent_Image_h
#define lambent_Image_h

#include "Window.h"

#include <cstdint>

namespace lambent
{
/**
 * Where the picture goes: a part of an image, row by row from the bottom, three channels a
 * pixel, as bytes or as floats (the other one is nullptr). And, where wanted, the number of
 * the triangle that each pixel shows, as SceneMesh counts them, or noTriangle.
 *
 * With n samples along each axis a pixel is the average of n x n pixels of the image of
 * n width x n height; the triangle is that of sample (n / 2, n / 2), rounded down.
 */
struct Image
{
  int width = 0, height = 0; ///< of the whole image
  Window part;               ///< what is made and stored of it
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
