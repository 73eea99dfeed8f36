// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a few triangles side by side, as kernels want them, and what they hit
 */
#ifndef lambent_CastBatch_h
#define lambent_CastBatch_h

#include "Window.h"

#include <cstdint>
#include <vector>

namespace lambent
{
/// A sample of the tile, and where its ray hits a triangle.
struct ExactHit
{
  std::uint32_t sample, triangle;
  double depth;
};

struct CastBatch
{
  static constexpr int capacity = 32;

  int count = 0;
  std::uint32_t triangles[capacity];
  Window boxes[capacity]; ///< of samples, from the tile's first
  bool cullFront[capacity], cullBack[capacity];

  /// The corners' coordinates: ax, ay, az, bx, ... in the world.
  alignas(64) double points[9][capacity];

  /// Comes out: the hits that float could not judge.
  std::vector<ExactHit> hits;
};
}

#endif
