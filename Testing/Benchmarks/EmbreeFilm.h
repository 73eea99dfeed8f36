// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief average the samples of a tile and write its pixels
 */
#ifndef EmbreeFilm_h
#define EmbreeFilm_h

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>

class EmbreeFilm
{
public:
  static constexpr int side = 16; ///< width and height of a tile, in samples

  /// `samples` is the number per pixel in each direction: 1, 2 or 4.
  EmbreeFilm(int width, int height, int samples, unsigned char* bytes)
    : Width(width)
    , Height(height)
    , Samples(samples)
    , Bytes(bytes)
  {
    if (samples != 1 && samples != 2 && samples != 4)
    {
      throw std::invalid_argument("a pixel has 1, 2 or 4 samples in each direction");
    }
  }

  /// The number of samples in a row and in a column of the picture.
  int columns() const { return this->Samples * this->Width; }
  int rows() const { return this->Samples * this->Height; }
  int samples() const { return this->Samples; }

  /// Write the part of a tile that lies in the picture. Its lower left sample is (i, j), and
  /// `values` are the grey values of its samples, from 0 to 255, row by row.
  void write(const float* values, int i, int j) const
  {
    switch (this->Samples)
    {
      case 1:
        return this->average<1>(values, i, j);
      case 2:
        return this->average<2>(values, i / 2, j / 2);
      default:
        return this->average<4>(values, i / 4, j / 4);
    }
  }

private:
  template <int samples>
  void average(const float* values, int i, int j) const
  {
    constexpr int pixels = side / samples;
    const int columns = std::min(pixels, this->Width - i);
    const int rows = std::min(pixels, this->Height - j);
    for (int row = 0; row < rows; ++row)
    {
      std::uint32_t grey[pixels];
      for (int k = 0; k < pixels; ++k)
      {
        const float* of = values + row * samples * side + k * samples;
        float sum = 0.0f;
        for (int n = 0; n < samples * samples; ++n)
        {
          sum += of[n / samples * side + n % samples];
        }
        grey[k] = static_cast<std::uint32_t>(
          static_cast<std::int32_t>(sum * (1.0f / (samples * samples)) + 0.5f));
      }
      std::uint32_t line[3 * pixels / 4];
      for (int k = 0; k < pixels / 4; ++k)
      {
        // Four grey pixels as twelve bytes, the first in the lowest byte.
        const std::uint32_t* four = grey + 4 * k;
        line[3 * k] = four[0] * 0x010101u | four[1] << 24;
        line[3 * k + 1] = four[1] * 0x0101u | four[2] * 0x01010000u;
        line[3 * k + 2] = four[2] | four[3] * 0x01010100u;
      }
      unsigned char* target =
        this->Bytes + 3 * (static_cast<std::size_t>(j + row) * this->Width + i);
      if (columns == pixels)
      {
        std::memcpy(target, line, 3 * pixels);
      }
      else
      {
        std::memcpy(target, line, 3 * static_cast<std::size_t>(columns));
      }
    }
  }

  int Width, Height, Samples;
  unsigned char* Bytes;
};

#endif
