// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief casts the rays of a tile's samples against the triangles in its bins
 *
 * castPlainly() is the definition: it transforms each primitive into the camera's frame and tests
 * it exactly against the rays of its box. cast() collects triangles for the kernel of
 * CastingKernel.h, which gives the same bits:
 *
 * 1. Collect the triangles of the tile's bins, without reading their points.
 * 2. If they may cover the tile many times, cast the nearest few first.
 * 3. Cast the others, but drop those that lie behind the hits of all samples.
 *
 * A policy, chosen at compile time, decides what to do with the hits. Nearest keeps the nearest hit
 * of each sample.
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
/// The samples of a tile, and their hits.
template <typename Policy>
struct TileHits
{
  TileSamples samples;
  Policy hits;

  /// Removes all hits. Windows are relative to the rendered part of the image.
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

  /// Tests the rays of a tile against triangles of a bin that contains the tile, at most a page of
  /// them.
  void castPlainly(
    const BinEntry* entries, int count, const TileGrid::Level& level, TileHits<Policy>& tile) const;

  /// The same with the kernel. Some triangles stay in the batch until flush().
  void cast(const BinEntry* entries, int count, const TileGrid::Level& level,
    TileHits<Policy>& tile, CastBatch& batch) const;
  void flush(TileHits<Policy>& tile, CastBatch& batch) const;

  /// Offers certain hits to the policy.
  void addHits(const Fragment* hits, int count, TileHits<Policy>& tile) const;

  /// Offers all hits of the same samples to the policy.
  void merge(const TileHits<Policy>& from, TileHits<Policy>& tile) const;

private:
  /// A triangle whose points are being prefetched.
  struct Candidate
  {
    const SceneMesh::Part* part;
    std::uint64_t corners[3];
  };
  void castWaiting(TileHits<Policy>& tile, CastBatch& batch) const;
  void castWaiting(int begin, int end, TileHits<Policy>& tile, CastBatch& batch) const;
  void castBatch(TileHits<Policy>& tile, CastBatch& batch) const;
  void fetch(const WaitingTriangle* const* triangles, int count, Candidate* candidates) const;
  void add(std::uint32_t number, const Candidate& candidate, const Window& box,
    TileHits<Policy>& tile, CastBatch& batch) const;

  Window boxIn(
    const TileSamples& samples, const TileGrid::Level& level, const BinEntry& entry) const;
  template <typename Primitive>
  void test(const Primitive& primitive, std::uint32_t number, const Window& box,
    TileHits<Policy>& tile) const;

  const FrameMesh& Mesh;
  const CameraFrame& Frame;
  const TileGrid& Grid;
};

extern template class Casting<Nearest>;
}

#endif
