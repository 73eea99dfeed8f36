// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the waiting triangles of a tile, a batch of them in the layout of the kernel, and its hits
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
  float nearest; ///< no hit is nearer
  Window box;    ///< samples, relative to the tile
};

struct CastBatch
{
  static constexpr int capacity = 32, mostWaiting = 1024;

  int waitingCount = 0;
  std::int64_t waitingArea = 0; ///< total area of their boxes, in samples
  WaitingTriangle waiting[mostWaiting];

  // Input of the kernel.
  int count = 0;
  std::uint32_t triangles[capacity];
  Window boxes[capacity]; ///< samples, relative to the tile
  bool cullFront[capacity], cullBack[capacity];

  /// The corners in world coordinates: ax, ay, az, bx, ...
  alignas(64) double points[9][capacity];

  // Output of the kernel.
  std::vector<ExactHit> hits; ///< those that float could not decide
  /// Before the batch was cast, each sample of the tile had a hit of at least this nearness.
  /// Triangles farther away change nothing.
  float least = -std::numeric_limits<float>::infinity();
};
}

#endif
