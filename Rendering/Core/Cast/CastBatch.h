// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the triangles of a tile that wait to be cast, a few of them in the layout of the kernel,
 * and their hits
 */
#ifndef lambent_CastBatch_h
#define lambent_CastBatch_h

#include "Window.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace lambent
{
/// A hit: a sample of the tile, the triangle that its ray hits, and the depth.
struct ExactHit
{
  std::uint32_t sample, triangle;
  double depth;
};

/// A triangle whose points have not been read.
struct WaitingTriangle
{
  std::uint32_t number;
  float nearest; ///< at least the nearness of all its hits
  Window box;    ///< in samples, from the first of the tile
};

struct CastBatch
{
  static constexpr int capacity = 32, mostWaiting = 1024;

  int waitingCount = 0;
  std::int64_t waitingArea = 0; ///< the sum over their boxes, in samples
  WaitingTriangle waiting[mostWaiting];

  // Input of the kernel.
  int count = 0;
  std::uint32_t triangles[capacity];
  Window boxes[capacity]; ///< in samples, from the first of the tile
  bool cullFront[capacity], cullBack[capacity];

  /// The corners in world coordinates: ax, ay, az, bx, ...
  alignas(64) double points[9][capacity];

  // Output of the kernel.
  std::vector<ExactHit> hits; ///< that float could not decide
  /// All samples of the tile had a hit of at least this nearness before the batch was cast.
  /// Triangles farther than this change nothing.
  float least = -std::numeric_limits<float>::infinity();
};
}

#endif
