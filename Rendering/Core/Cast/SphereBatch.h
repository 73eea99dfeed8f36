// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a batch of a tile's spheres, in the layout of the kernel, and their hits
 */
#ifndef lambent_SphereBatch_h
#define lambent_SphereBatch_h

#include "ExactHit.h"
#include "Window.h"

#include <vector>

namespace lambent
{
struct SphereBatch
{
  static constexpr int capacity = 32;
  static constexpr int room = capacity + 8; ///< a vector may reach beyond the last

  // Input of the kernel.
  int count = 0;
  std::uint32_t spheres[capacity];
  Window boxes[capacity]; ///< samples, relative to the tile
  float nearest[capacity];
  bool hasOutside[capacity], hasInside[capacity]; ///< the sides that are drawn
  alignas(64) double centers[3][room];            ///< in the world
  double radii[capacity];

  // Output of the kernel.
  std::vector<ExactHit> hits; ///< those whose order with earlier hits float could not decide
};
}

#endif
