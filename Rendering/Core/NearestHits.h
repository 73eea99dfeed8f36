// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the nearest hit of each ray of a cell
 */
#ifndef lambent_NearestHits_h
#define lambent_NearestHits_h

#include "Mesh.h"
#include "Window.h"

#include <limits>
#include <vector>

namespace lambent
{
/// Depth and triangle for each ray of a window, row by row. Of two hits the one
/// with the smaller depth is kept, at the same depth the one with the smaller
/// number, so that the order in which they come does not matter.
class NearestHits
{
public:
  const Window& window() const { return this->Rays; }

  /// Start anew, with nothing hit.
  void reset(const Window& rays)
  {
    this->Rays = rays;
    const std::size_t size = static_cast<std::size_t>(rays.width()) * rays.height();
    this->Depths.assign(size, std::numeric_limits<double>::infinity());
    this->Triangles.assign(size, noTriangle);
  }

  std::size_t index(int i, int j) const
  {
    return static_cast<std::size_t>(j - this->Rays.j0) * this->Rays.width() + (i - this->Rays.i0);
  }

  void offer(std::size_t index, double depth, std::uint32_t triangle)
  {
    double& nearest = this->Depths[index];
    if (depth < nearest || (depth == nearest && triangle < this->Triangles[index]))
    {
      nearest = depth;
      this->Triangles[index] = triangle;
    }
  }

  /// Offer all hits of another one of the same window.
  void merge(const NearestHits& other)
  {
    for (std::size_t k = 0; k < this->Triangles.size(); ++k)
    {
      this->offer(k, other.Depths[k], other.Triangles[k]);
    }
  }

  std::uint32_t triangle(std::size_t index) const { return this->Triangles[index]; }

private:
  Window Rays;
  std::vector<double> Depths;
  std::vector<std::uint32_t> Triangles;
};
}

#endif
