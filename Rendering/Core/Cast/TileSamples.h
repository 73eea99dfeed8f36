// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the samples of one tile: where their rays cross the image plane
 *
 * Samples are numbered row by row. Rows begin stride() apart, and a vector may reach beyond the end
 * of a row.
 */
#ifndef lambent_TileSamples_h
#define lambent_TileSamples_h

#include "CameraFrame.h"
#include "TileGrid.h"
#include "Window.h"

#include <algorithm>
#include <vector>

namespace lambent
{
class TileSamples
{
public:
  static constexpr int widestVector = 16; ///< in floats

  /// Windows are relative to the rendered part of the image.
  void reset(
    const CameraFrame& frame, const Window& part, const TileGrid& grid, const Window& samples)
  {
    this->Samples = samples;
    this->Stride = 1 << grid.rowShift();
    this->Xs.resize(this->Stride + widestVector);
    this->Ys.resize(this->Stride + widestVector);
    for (int k = 0; k < this->Stride; ++k)
    {
      // Samples beyond the window are unused, and their numbers may not fit an int.
      this->Xs[k] = frame.x(part.i0 + samples.i0 + std::min(k, samples.width() - 1));
      this->Ys[k] = frame.y(part.j0 + samples.j0 + std::min(k, samples.height() - 1));
    }
  }

  const Window& window() const { return this->Samples; }
  int stride() const { return this->Stride; }
  /// The number of samples, including the unused ones between rows.
  std::size_t size() const
  {
    return static_cast<std::size_t>(this->Stride) * this->Samples.height();
  }

  /// Positions on the image plane, by column and by row of the tile.
  const double* xs() const { return this->Xs.data(); }
  const double* ys() const { return this->Ys.data(); }
  double x(std::size_t sample) const { return this->Xs[sample % this->Stride]; }
  double y(std::size_t sample) const { return this->Ys[sample / this->Stride]; }

private:
  Window Samples;
  int Stride = 0;
  std::vector<double> Xs, Ys;
};
}

#endif
