// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cast the rays of a tile's samples at the triangles in its bins
 *
 * A triangle is brought into the camera's frame and tested with intersect() against the rays
 * of its box. That is the definition, and what castPlainly() does. cast() collects triangles
 * and leaves them to the kernel of CastingKernel.h, which gives the same bits.
 *
 * What becomes of the hits is up to the policy, chosen at compile time: Nearest keeps the
 * nearest of each sample.
 */
#ifndef lambent_Casting_h
#define lambent_Casting_h

#include "Bins.h"
#include "CastBatch.h"
#include "FrameMesh.h"
#include "Nearest.h"
#include "TileSamples.h"

namespace lambent
{
/// A tile with the hits of its samples.
template <typename Policy>
struct TileHits
{
  TileSamples samples;
  Policy hits;

  /// Start anew, with nothing hit. Windows count from the image's part that is made.
  void reset(
    const CameraFrame& frame, const Window& part, const TileGrid& grid, const Window& window)
  {
    this->samples.reset(frame, part, grid, window);
    this->hits.reset(this->samples.size() + TileSamples::widestVector);
  }
};

template <typename Policy>
class Casting
{
public:
  Casting(const FrameMesh& mesh, const TileGrid& grid)
    : Mesh(mesh)
    , Frame(mesh.frame())
    , Grid(grid)
  {
  }

  /// Test a tile's rays against triangles of a bin that the tile lies in, a page of them at
  /// the most.
  void castPlainly(
    const BinEntry* entries, int count, const TileGrid::Level& level, TileHits<Policy>& tile) const;

  /// The same with the kernel; some of them stay in the batch until flush().
  void cast(const BinEntry* entries, int count, const TileGrid::Level& level,
    TileHits<Policy>& tile, CastBatch& batch) const;
  void flush(TileHits<Policy>& tile, CastBatch& batch) const;

  /// Offer hits that are certain.
  void addHits(const Fragment* hits, int count, TileHits<Policy>& tile) const;

  /// Offer all hits of the same samples.
  void merge(const TileHits<Policy>& from, TileHits<Policy>& tile) const;

private:
  /// A triangle whose points are on their way from memory.
  struct Candidate
  {
    const SceneMesh::Part* part;
    std::uint64_t corners[3];
  };
  void fetch(const BinEntry* entries, int count, Candidate* candidates) const;
  void add(std::uint32_t number, const Candidate& candidate, const Window& box,
    TileHits<Policy>& tile, CastBatch& batch) const;

  Window boxIn(
    const TileSamples& samples, const TileGrid::Level& level, const BinEntry& entry) const;
  void test(const FrameTriangle& triangle, std::uint32_t number, const Window& box,
    TileHits<Policy>& tile) const;

  const FrameMesh& Mesh;
  const CameraFrame& Frame;
  const TileGrid& Grid;
};

extern template class Casting<Nearest>;
}

#endif
