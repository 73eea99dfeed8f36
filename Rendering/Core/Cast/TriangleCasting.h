// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief casts the rays of a tile against triangles, with the kernel of CastingKernel.h
 *
 * 1. Prefetch the points of many triangles.
 * 2. Copy them into a batch. Cast it when it is full.
 * 3. Offer the hits that the kernel could not decide in float to the policy, with their depths.
 */
#ifndef lambent_TriangleCasting_h
#define lambent_TriangleCasting_h

#include "Layers.h"
#include "TileHits.h"
#include "TriangleBatch.h"
#include "WaitingPrimitives.h"

namespace lambent
{
template <typename Policy>
class TriangleCasting
{
public:
  explicit TriangleCasting(const FrameMesh& mesh)
    : Mesh(mesh)
  {
  }

  static constexpr int atOnce = 32;

  /// Casts up to `atOnce` triangles. Some stay in the batch until flush().
  void cast(
    const NextPrimitive* triangles, int count, TileHits<Policy>& tile, TriangleBatch& batch) const;

  /// Casts the batch. Also finds tile.least.
  void flush(TileHits<Policy>& tile, TriangleBatch& batch) const;

private:
  using Corners = std::uint64_t[3];
  void fetch(const NextPrimitive* triangles, int count, Corners* corners) const;
  void add(const NextPrimitive& triangle, const Corners& corners, TileHits<Policy>& tile,
    TriangleBatch& batch) const;

  const FrameMesh& Mesh;
};

extern template class TriangleCasting<Nearest>;
extern template class TriangleCasting<Layers>;
}

#endif
