// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the samples of a tile, and their hits
 */
#ifndef lambent_TileHits_h
#define lambent_TileHits_h

#include "ExactHit.h"
#include "FrameMesh.h"
#include "Nearness.h"
#include "TileSamples.h"

#include <limits>
#include <vector>

namespace lambent
{
template <typename Policy>
struct TileHits
{
  TileSamples samples;
  Policy hits;
  /// Each sample has a hit of at least this nearness. Primitives farther away change nothing.
  float least = -std::numeric_limits<float>::infinity();

  /// Removes all hits. Windows are relative to the rendered part of the image.
  void reset(
    const CameraFrame& frame, const Window& part, const TileGrid& grid, const Window& window)
  {
    this->samples.reset(frame, part, grid, window);
    this->hits.reset(this->samples.size() + TileSamples::widestVector);
    this->least = -std::numeric_limits<float>::infinity();
  }
};

/// Returns a function that computes the depth of a primitive at a sample of a tile.
inline auto depthIn(const FrameMesh& mesh, const TileSamples& samples)
{
  return [&mesh, &samples](std::uint32_t primitive, std::size_t sample)
  {
    double depth;
    mesh.hits(primitive, samples.x(sample), samples.y(sample), depth);
    return depth;
  };
}

/// Offers hits whose depths are known, and removes them from the list.
template <typename Policy>
void offerHits(const FrameMesh& mesh, TileHits<Policy>& tile, std::vector<ExactHit>& hits)
{
  for (const ExactHit& hit : hits)
  {
    tile.hits.offer(hit.sample, hit.primitive, nearnessOf(hit.depth, mesh.frame().parallel),
      hit.depth, depthIn(mesh, tile.samples));
  }
  hits.clear();
}
}

#endif
