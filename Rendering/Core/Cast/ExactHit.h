// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a hit of known depth
 */
#ifndef lambent_ExactHit_h
#define lambent_ExactHit_h

#include <cstdint>

namespace lambent
{
/// A hit: a sample of the tile, the primitive that its ray hits, and the depth.
struct ExactHit
{
  std::uint32_t sample, primitive;
  double depth;
};
}

#endif
