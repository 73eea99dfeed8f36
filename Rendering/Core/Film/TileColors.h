// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the linear colours of a tile's samples, and their alpha, before averaging
 */
#ifndef lambent_TileColors_h
#define lambent_TileColors_h

#include <cstddef>
#include <vector>

namespace lambent
{
/// Rows of samples from the bottom, one array per channel.
class TileColors
{
public:
  /// Resizes the arrays. Their contents are undefined.
  void reset(int width, int height, int channels)
  {
    constexpr std::size_t beyondEnd = 16 * 8; // values that averageSamples() may read
    this->Stride = width;
    for (int channel = 0; channel < channels; ++channel)
    {
      this->Channels[channel].resize(static_cast<std::size_t>(width) * height + beyondEnd);
    }
  }

  int stride() const { return this->Stride; }
  const double* row(int channel, int j) const
  {
    return this->Channels[channel].data() + static_cast<std::size_t>(j) * this->Stride;
  }
  double* at(int channel, int i, int j)
  {
    return this->Channels[channel].data() + static_cast<std::size_t>(j) * this->Stride + i;
  }

private:
  int Stride = 0;
  std::vector<double> Channels[4];
};
}

#endif
