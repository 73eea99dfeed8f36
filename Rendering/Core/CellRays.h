// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the rays of one cell: where they are and the nearest hit of each
 */
#ifndef lambent_CellRays_h
#define lambent_CellRays_h

#include "CameraFrame.h"
#include "Window.h"

#include <cstdint>
#include <vector>

namespace lambent
{
/**
 * Depth and triangle of the nearest hit for each ray of a cell. Of two hits the
 * one with the smaller depth is kept, at the same depth the one with the smaller
 * number, so that the order in which they come does not matter.
 *
 * Rows are padded to a multiple of the widest vector that kernels use, and the
 * numbers of triangles are as wide as the depths, for their sake.
 */
class CellRays
{
public:
  /// What is hit where nothing is.
  static constexpr std::int64_t none = -1;
  static constexpr int padding = 8;

  /// Start anew, with nothing hit. Windows count from the image's part that is made.
  void reset(const CameraFrame& frame, const Window& image, const Window& rays)
  {
    this->Rays = rays;
    this->Stride = (rays.width() + padding - 1) / padding * padding;
    this->Xs.resize(this->Stride);
    this->Ys.resize((rays.height() + padding - 1) / padding * padding);
    for (int i = 0; i < this->Stride; ++i)
    {
      this->Xs[i] = frame.x(image.i0 + rays.i0 + i);
    }
    for (std::size_t j = 0; j < this->Ys.size(); ++j)
    {
      this->Ys[j] = frame.y(image.j0 + rays.j0 + static_cast<int>(j));
    }
    const std::size_t size = static_cast<std::size_t>(this->Stride) * rays.height();
    this->Depths.assign(size, std::numeric_limits<double>::infinity());
    this->Triangles.assign(size, none);
  }

  const Window& window() const { return this->Rays; }
  int stride() const { return this->Stride; }

  /// The rays' places on the image plane, by column and by row of the cell.
  const double* xs() const { return this->Xs.data(); }
  const double* ys() const { return this->Ys.data(); }
  double* depths() { return this->Depths.data(); }
  std::int64_t* triangles() { return this->Triangles.data(); }
  const std::int64_t* triangles() const { return this->Triangles.data(); }

  void offer(std::size_t index, double depth, std::int64_t triangle)
  {
    double& nearest = this->Depths[index];
    if (depth < nearest || (depth == nearest && triangle < this->Triangles[index]))
    {
      nearest = depth;
      this->Triangles[index] = triangle;
    }
  }

  /// Offer all hits of the same cell's rays at other triangles.
  void merge(const CellRays& other)
  {
    for (std::size_t k = 0; k < this->Triangles.size(); ++k)
    {
      this->offer(k, other.Depths[k], other.Triangles[k]);
    }
  }

private:
  Window Rays;
  int Stride = 0;
  std::vector<double> Xs, Ys;
  std::vector<double> Depths;
  std::vector<std::int64_t> Triangles;
};
}

#endif
