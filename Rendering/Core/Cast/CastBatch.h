// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a few triangles in the layout of the kernel, and their hits
 */
#ifndef lambent_CastBatch_h
#define lambent_CastBatch_h

#include "Window.h"

#include <cstdint>
#include <vector>

namespace lambent
{
/// A hit: a sample of the tile, the triangle that its ray hits, and the depth.
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
  Window boxes[capacity]; ///< in samples, from the first of the tile
  bool cullFront[capacity], cullBack[capacity];

  /// The corners in world coordinates: ax, ay, az, bx, ...
  alignas(64) double points[9][capacity];

  /// Output: the hits that float could not decide.
  std::vector<ExactHit> hits;
};
}

#endif
