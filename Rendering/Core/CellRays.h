// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the rays of one cell: where they are and the nearest hit of each
 */
#ifndef lambent_CellRays_h
#define lambent_CellRays_h

#include "CameraFrame.h"
#include "CellGrid.h"
#include "Window.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace lambent
{
/**
 * Two hits for each ray of a cell: the nearest of those whose depth is known, and
 * the nearest of those of which only a range of depths is. Casting keeps both and
 * settles in the end which of them is nearer.
 *
 * Of two hits the one with the smaller depth is kept, at the same depth the one with
 * the smaller number of its triangle, so that the order in which they come does not
 * matter.
 */
class CellRays
{
public:
  /// The triangle where nothing is hit.
  static constexpr std::int64_t none = -1;

  /// Start anew, with nothing hit. Windows count from the image's part that is made.
  void reset(
    const CameraFrame& frame, const Window& image, const CellGrid& grid, const Window& rays)
  {
    this->Rays = rays;
    this->Stride = 1 << grid.rayShift();
    this->Xs.resize(this->Stride);
    this->Ys.resize(this->Stride);
    for (int k = 0; k < this->Stride; ++k)
    {
      this->Xs[k] = frame.x(image.i0 + rays.i0 + k);
      this->Ys[k] = frame.y(image.j0 + rays.j0 + k);
    }
    const std::size_t size = static_cast<std::size_t>(this->Stride) * rays.height();
    this->Depths.assign(size, std::numeric_limits<double>::infinity());
    this->Triangles.assign(size, none);
    this->Ranges.assign(size, Range());
  }

  const Window& window() const { return this->Rays; }
  std::size_t size() const { return this->Depths.size(); }
  int stride() const { return this->Stride; }

  /// The rays' places on the image plane, by column and by row of the cell.
  const double* xs() const { return this->Xs.data(); }
  const double* ys() const { return this->Ys.data(); }
  double x(std::size_t ray) const { return this->Xs[ray % this->Stride]; }
  double y(std::size_t ray) const { return this->Ys[ray / this->Stride]; }

  /// Hits of known depth, by ray.
  double* depths() { return this->Depths.data(); }
  std::int64_t* triangles() { return this->Triangles.data(); }
  const std::int64_t* triangles() const { return this->Triangles.data(); }

  void offer(std::size_t ray, double depth, std::int64_t triangle)
  {
    double& nearest = this->Depths[ray];
    if (depth < nearest || (depth == nearest && triangle < this->Triangles[ray]))
    {
      nearest = depth;
      this->Triangles[ray] = triangle;
    }
  }

  /// A hit with a depth from near to far.
  struct Range
  {
    float near = std::numeric_limits<float>::infinity();
    float far = std::numeric_limits<float>::infinity();
    std::int64_t triangle = none;
  };
  Range* ranges() { return this->Ranges.data(); }

  /// Offer all hits of known depth of the same rays.
  void merge(const CellRays& other)
  {
    for (std::size_t ray = 0; ray < this->size(); ++ray)
    {
      if (other.Triangles[ray] != none)
      {
        this->offer(ray, other.Depths[ray], other.Triangles[ray]);
      }
    }
  }

private:
  Window Rays;
  int Stride = 0;
  std::vector<double> Xs, Ys;
  std::vector<double> Depths;
  std::vector<std::int64_t> Triangles;
  std::vector<Range> Ranges;
};
}

#endif
