// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the hits of each sample of a tile, from the nearest to the farthest
 *
 * The order is by depth; at equal depths, by the number of the primitive. It is total, so it does
 * not depend on the order in which the hits came.
 *
 * A ray through an edge hits the triangles on both sides of it, and a ray through a corner all
 * triangles around it. If each of them were seen, edges would be more opaque than faces. So of the
 * hits of transparent triangles on the same edge or corner, only the first is kept. Edges and
 * corners are the same if their points have the same coordinates, in whatever surface.
 *
 * 1. Sort by sample, by counting.
 * 2. Sort the hits of each sample. Ranges of nearness decide if they do not overlap. Otherwise the
 *    depths are computed and compared, as the policy Nearest does.
 * 3. Remove the repeated hits. Hits on the same edge have nearly the same depth, so that their
 *    ranges overlap. Hence only hits whose depths have been computed are examined.
 */
#ifndef lambent_SortedLayers_h
#define lambent_SortedLayers_h

#include "Layers.h"
#include "TileHits.h"

#include <vector>

namespace lambent
{
class SortedLayers
{
public:
  /// Sorts the layers of a tile, with the nearest opaque hit of each sample among them.
  void sort(const FrameMesh& mesh, const TileHits<Nearest>& opaque, const Layers& layers);

  /// The number of hits of a sample.
  std::uint32_t count(std::size_t sample) const { return this->Counts[sample]; }
  /// The primitive of hit k of a sample.
  std::uint32_t primitive(std::size_t sample, std::uint32_t k) const
  {
    return this->Primitives[this->Firsts[sample] + k];
  }

private:
  void countOf(const TileHits<Nearest>& opaque, const Layers& layers);
  void place(const Layer& layer) { this->Sorted[this->Firsts[layer.sample]++] = layer; }

  std::vector<std::uint32_t> Firsts;     ///< of each sample, and the end
  std::vector<std::uint32_t> Counts;     ///< of each sample, without repeated hits
  std::vector<Layer> Sorted;             ///< by sample, then by depth
  std::vector<std::uint32_t> Primitives; ///< of Sorted, without repeated hits
};
}

#endif
