// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the bounding box of a scene's primitives
 */
#ifndef lambent_Bounds_h
#define lambent_Bounds_h

#include "Parallel.h"
#include "Scene.h"

#include <limits>

namespace lambent
{
struct Bounds
{
  Vec3 low{ std::numeric_limits<double>::infinity() };
  Vec3 high{ -std::numeric_limits<double>::infinity() };

  bool empty() const { return !(this->low.x <= this->high.x); }

  void add(const Vec3& point) { this->add(Bounds{ point, point }); }

  void add(const Bounds& other)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->low[axis] = std::min(this->low[axis], other.low[axis]);
      this->high[axis] = std::max(this->high[axis], other.high[axis]);
    }
  }
};

/// The bounds of all primitives. Ignores points that no primitive uses, corners whose point does
/// not exist, and points that are not finite.
Bounds findBounds(const std::vector<Surface>& surfaces, const Parallel& parallel);
}

#endif
