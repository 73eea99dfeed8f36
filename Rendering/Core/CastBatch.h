// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a few triangles side by side, as kernels want them
 */
#ifndef lambent_CastBatch_h
#define lambent_CastBatch_h

#include "Window.h"

#include <cstdint>

namespace lambent
{
/// Triangles whose boxes are exact and all of the same few rays, not to be culled.
struct SmallBatch
{
  static constexpr int capacity = 32;

  int count = 0;
  std::uint32_t triangles[capacity];
  std::uint32_t firstRays[capacity]; ///< of the cell, the lower left one of each box

  /// The corners' coordinates: ax, ay, az, bx, ... in the world.
  alignas(64) double points[9][capacity];
  /// The pixel of the image that the lower left ray of the box is in.
  alignas(64) double i[capacity], j[capacity];
};

/// Any triangles.
struct LargeBatch
{
  static constexpr int capacity = 32;

  int count = 0;
  std::uint32_t triangles[capacity];
  Window boxes[capacity];    ///< of rays, from the cell's first
  bool isBoxExact[capacity]; ///< its rays certainly pass intersect()'s box test
  bool cullFront[capacity], cullBack[capacity];

  /// As above.
  alignas(64) double points[9][capacity];
};

/// The triangles that a worker has collected, those with boxes of up to four by four
/// rays by the size of the boxes.
struct CastBatches
{
  static constexpr int side = 4;

  SmallBatch small[side][side]; ///< by height - 1 and width - 1
  LargeBatch large;
};
}

#endif
