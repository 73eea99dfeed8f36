// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the linear colours of a tile's samples, before averaging
 */
#ifndef lambent_TileColors_h
#define lambent_TileColors_h

#include "Arithmetic.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lambent
{
/// Rows of samples from the bottom, one array per channel.
class TileColors
{
public:
  /// Resizes the arrays. Their contents are undefined.
  void reset(int width, int height)
  {
    constexpr std::size_t beyondEnd = 16 * 8; // values that averageSamples() may read
    this->Stride = width;
    for (std::vector<double>& channel : this->Channels)
    {
      channel.resize(static_cast<std::size_t>(width) * height + beyondEnd);
    }
  }

  int stride() const { return this->Stride; }
  const double* row(int channel, int j) const
  {
    return this->Channels[channel].data() + static_cast<std::size_t>(j) * this->Stride;
  }

  void fill(int i, int j, int count, const Vec3& color)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      std::fill_n(this->at(channel, i, j), count, color[channel]);
    }
  }

  void store(int i, int j, int count, const double* red, const double* green, const double* blue)
  {
    std::copy_n(red, count, this->at(0, i, j));
    std::copy_n(green, count, this->at(1, i, j));
    std::copy_n(blue, count, this->at(2, i, j));
  }

private:
  double* at(int channel, int i, int j)
  {
    return this->Channels[channel].data() + static_cast<std::size_t>(j) * this->Stride + i;
  }

  int Stride = 0;
  std::vector<double> Channels[3];
};
}

#endif
