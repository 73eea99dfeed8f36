// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the primitives that a tile has yet to cast
 */
#ifndef lambent_WaitingPrimitives_h
#define lambent_WaitingPrimitives_h

#include "SceneMesh.h"
#include "Window.h"

#include <cstdint>

namespace lambent
{
/// A primitive whose points have not been read.
struct WaitingPrimitive
{
  std::uint32_t number;
  float nearest; ///< no hit is nearer
  Window box;    ///< samples, relative to the tile
};

struct WaitingPrimitives
{
  static constexpr int capacity = 1024;

  int count = 0;
  std::int64_t area = 0; ///< total area of their boxes, in samples
  WaitingPrimitive items[capacity];
};

/// A primitive to be cast next, and the surface that it belongs to.
struct NextPrimitive
{
  const WaitingPrimitive* waiting;
  const SceneMesh::Part* part;
};
}

#endif
