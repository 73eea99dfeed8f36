// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief casts the rays of a tile against spheres, with the kernel of SphereCastingKernel.h
 *
 * 1. Prefetch the centres of many spheres.
 * 2. Copy them into a batch. Cast it when it is full.
 * 3. Offer the hits whose order the kernel could not decide to the policy, with their depths.
 */
#ifndef lambent_SphereCasting_h
#define lambent_SphereCasting_h

#include "Layers.h"
#include "SphereBatch.h"
#include "TileHits.h"
#include "WaitingPrimitives.h"

namespace lambent
{
template <typename Policy>
class SphereCasting
{
public:
  explicit SphereCasting(const FrameMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Casts spheres. Some stay in the batch until flush().
  void cast(
    const NextPrimitive* spheres, int count, TileHits<Policy>& tile, SphereBatch& batch) const;

  /// Casts the batch. Also finds tile.least.
  void flush(TileHits<Policy>& tile, SphereBatch& batch) const;

private:
  void add(const NextPrimitive& sphere, TileHits<Policy>& tile, SphereBatch& batch) const;

  const FrameMesh& Mesh;
};

extern template class SphereCasting<Nearest>;
extern template class SphereCasting<Layers>;
}

#endif
