// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cast the rays of a tile at the triangles in its bins
 *
 * A triangle is brought into the camera's frame and tested with intersect()
 * against the rays of its box. That is the definition, and what castPlainly()
 * does. cast() collects triangles and leaves them to the kernel of CastingKernel.h,
 * which gives the same bits.
 *
 * A hit comes with a range of nearness, or with its depth. Where two ranges do not
 * overlap they tell which hit is nearer; elsewhere both depths are computed.
 */
#ifndef lambent_Casting_h
#define lambent_Casting_h

#include "Bins.h"
#include "CastBatch.h"
#include "FrameMesh.h"
#include "TileSamples.h"

namespace lambent
{
class Casting
{
public:
  Casting(const FrameMesh& mesh, const TileGrid& grid)
    : Mesh(mesh)
    , Frame(mesh.frame())
    , Grid(grid)
  {
  }

  /// Offer to the rays of a tile what they meet of triangles in a bin that it is in, a
  /// page of them at the most.
  void castPlainly(
    const BinEntry* entries, int count, const TileGrid::Level& level, TileSamples& rays) const;

  /// The same with the kernel; some of it is left in the batch until flush().
  void cast(const BinEntry* entries, int count, const TileGrid::Level& level, TileSamples& rays,
    CastBatch& batch) const;
  void flush(TileSamples& rays, CastBatch& batch) const;

  /// Offer hits that are certain.
  void addHits(const Fragment* hits, int count, TileSamples& rays) const;

  /// Offer all hits of the same rays.
  void merge(const TileSamples& from, TileSamples& rays) const;

private:
  /// A triangle whose points are on their way from memory.
  struct Candidate
  {
    const SceneMesh::Part* part;
    std::uint64_t corners[3];
  };
  void fetch(const BinEntry* entries, int count, Candidate* candidates) const;
  void add(std::uint32_t number, const Candidate& candidate, const Window& box, TileSamples& rays,
    CastBatch& batch) const;

  Window boxIn(const TileSamples& rays, const TileGrid::Level& level, const BinEntry& entry) const;
  void test(const FrameTriangle& triangle, std::uint32_t number, const Window& box,
    TileSamples& rays) const;

  void offer(const Fragment& hit, TileSamples& rays) const;
  void offer(std::size_t ray, double depth, std::uint32_t triangle, TileSamples& rays) const;
  void findDepth(std::size_t ray, TileSamples& rays) const;
  double depthAt(std::uint32_t triangle, const TileSamples& rays, std::size_t ray) const;

  const FrameMesh& Mesh;
  const CameraFrame& Frame;
  const TileGrid& Grid;
};
}

#endif
