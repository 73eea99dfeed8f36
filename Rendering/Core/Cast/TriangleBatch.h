// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a batch of a tile's triangles, in the layout of the kernel, and their hits
 */
#ifndef lambent_TriangleBatch_h
#define lambent_TriangleBatch_h

#include "ExactHit.h"
#include "Window.h"

#include <cstdint>
#include <vector>

namespace lambent
{
struct TriangleBatch
{
  static constexpr int capacity = 32;

  // Input of the kernel.
  int count = 0;
  std::uint32_t triangles[capacity];
  Window boxes[capacity]; ///< samples, relative to the tile
  bool cullFront[capacity], cullBack[capacity];

  /// The corners in world coordinates: ax, ay, az, bx, ...
  alignas(64) double points[9][capacity];

  // Output of the kernel.
  std::vector<ExactHit> hits; ///< those that float could not decide
};
}

#endif
