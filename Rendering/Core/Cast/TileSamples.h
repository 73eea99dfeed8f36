// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the rays of one tile: where they are and the nearest hit of each
 */
#ifndef lambent_TileSamples_h
#define lambent_TileSamples_h

#include "CameraFrame.h"
#include "Nearness.h"
#include "SceneMesh.h"
#include "TileGrid.h"
#include "Window.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace lambent
{
/**
 * Of two hits of a ray the one with the smaller depth is kept, at the same depth the
 * one with the smaller number of its triangle, so that the order in which they come
 * does not matter.
 *
 * A hit has its triangle and its range of nearness. Its depth is computed only when
 * the range does not tell enough, and remembered then.
 *
 * Rays are numbered row by row. Rows begin stride() apart, and there is room for a
 * vector to reach beyond a row's end.
 */
class TileSamples
{
public:
  /// Start anew, with nothing hit. Windows count from the image's part that is made.
  void reset(
    const CameraFrame& frame, const Window& image, const TileGrid& grid, const Window& rays)
  {
    this->Rays = rays;
    this->Stride = 1 << grid.rayShift();
    this->Xs.resize(this->Stride + vector);
    this->Ys.resize(this->Stride + vector);
    for (int k = 0; k < this->Stride; ++k)
    {
      this->Xs[k] = frame.x(image.i0 + rays.i0 + k);
      this->Ys[k] = frame.y(image.j0 + rays.j0 + k);
    }
    const std::size_t size = this->size() + vector;
    this->Lows.assign(size, noNearness.low);
    this->Highs.assign(size, noNearness.high);
    this->Triangles.assign(size, noTriangle);
    this->Depths.resize(size); // means nothing where nothing is hit
    this->DepthOwners.assign(size, noTriangle);
  }

  const Window& window() const { return this->Rays; }
  std::size_t size() const { return static_cast<std::size_t>(this->Stride) * this->Rays.height(); }
  int stride() const { return this->Stride; }

  /// The rays' places on the image plane, by column and by row of the tile.
  const double* xs() const { return this->Xs.data(); }
  const double* ys() const { return this->Ys.data(); }
  double x(std::size_t ray) const { return this->Xs[ray % this->Stride]; }
  double y(std::size_t ray) const { return this->Ys[ray / this->Stride]; }

  /// The nearest hits, by ray: their ranges of nearness, and their triangles.
  float* lows() { return this->Lows.data(); }
  float* highs() { return this->Highs.data(); }
  std::uint32_t* triangles() { return this->Triangles.data(); }
  const float* lows() const { return this->Lows.data(); }
  const float* highs() const { return this->Highs.data(); }
  const std::uint32_t* triangles() const { return this->Triangles.data(); }

  /// Keep a hit that is the nearest.
  void set(std::size_t ray, std::uint32_t triangle, const Nearness& range)
  {
    this->Lows[ray] = range.low;
    this->Highs[ray] = range.high;
    this->Triangles[ray] = triangle;
  }

  /// Whether the depth of a ray's hit is known. That of no hit is: infinite.
  bool knowsDepth(std::size_t ray) const { return this->DepthOwners[ray] == this->Triangles[ray]; }
  double depth(std::size_t ray) const
  {
    return this->Triangles[ray] == noTriangle ? std::numeric_limits<double>::infinity()
                                              : this->Depths[ray];
  }
  void setDepth(std::size_t ray, double depth)
  {
    this->Depths[ray] = depth;
    this->DepthOwners[ray] = this->Triangles[ray];
  }

  /// Keep a hit of known depth if it is the nearest, where that of the ray's hit is
  /// known, too.
  void offer(std::size_t ray, double depth, std::uint32_t triangle, const Nearness& range)
  {
    const double nearest = this->depth(ray);
    if (depth < nearest || (depth == nearest && triangle < this->Triangles[ray]))
    {
      this->set(ray, triangle, range);
      this->setDepth(ray, depth);
    }
  }

private:
  static constexpr int vector = 16; ///< the widest that there is, of floats

  Window Rays;
  int Stride = 0;
  std::vector<double> Xs, Ys;
  std::vector<float> Lows, Highs;
  std::vector<std::uint32_t> Triangles;
  std::vector<double> Depths;
  std::vector<std::uint32_t> DepthOwners; ///< the triangles that these are of
};
}

#endif
