// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief casts the rays of a tile's samples against the primitives in its bins
 *
 * castPlainly() is the definition: it transforms each primitive into the camera's frame and tests
 * it exactly against the rays of its box. cast() gives the same bits:
 *
 * 1. Collect the primitives of the tile's bins, without reading their points.
 * 2. If they may cover the tile many times, cast the nearest few first.
 * 3. Cast the others, but drop those that lie behind the hits of all samples.
 *
 * Each kind of primitive is cast with kernels of its own (TriangleCasting.h, SphereCasting.h,
 * LineCasting.h).
 *
 * A policy, chosen at compile time, decides what to do with the hits. Nearest keeps the nearest hit
 * of each sample. In a scene that has transparent surfaces, it only takes the opaque ones; Layers
 * takes the transparent ones, and keeps all hits.
 */
#ifndef lambent_Casting_h
#define lambent_Casting_h

#include "Bins.h"
#include "LineCasting.h"
#include "SphereCasting.h"
#include "TriangleCasting.h"

namespace lambent
{
/// A worker's scratch memory.
struct CastingMemory
{
  WaitingPrimitives waiting;
  TriangleBatch triangles;
  SphereBatch spheres;
  std::vector<ExactHit> lineHits;
};

template <typename Policy>
class Casting
{
public:
  Casting(const FrameMesh& mesh, const TileGrid& grid)
    : Mesh(mesh)
    , Frame(mesh.frame())
    , Grid(grid)
    , Triangles(mesh)
    , Spheres(mesh)
    , Lines(mesh)
    , IsMixed(mesh.mesh().hasTransparency())
  {
  }

  /// Tests the rays of a tile against primitives of a bin that contains the tile, at most a page of
  /// them.
  void castPlainly(
    const BinEntry* entries, int count, const TileGrid::Level& level, TileHits<Policy>& tile) const;

  /// The same with kernels. Some primitives wait until flush().
  void cast(const BinEntry* entries, int count, const TileGrid::Level& level,
    TileHits<Policy>& tile, CastingMemory& memory) const;
  void flush(TileHits<Policy>& tile, CastingMemory& memory) const;

  /// Offers certain hits to the policy.
  void addHits(const Fragment* hits, int count, TileHits<Policy>& tile) const;

  /// Offers all hits of the same samples to the policy.
  void merge(const TileHits<Policy>& from, TileHits<Policy>& tile) const;

private:
  /// Whether the policy takes the primitives of a part.
  bool takes(const SceneMesh::Part& part) const
  {
    return !this->IsMixed || part.isTransparent() == Policy::isForTransparent;
  }
  bool takes(std::uint32_t primitive) const
  {
    return !this->IsMixed || this->takes(this->Mesh.mesh().partOf(primitive));
  }
  void castWaiting(TileHits<Policy>& tile, CastingMemory& memory) const;
  void castWaiting(int begin, int end, TileHits<Policy>& tile, CastingMemory& memory) const;

  void castNext(
    NextPrimitive* next, int count, TileHits<Policy>& tile, CastingMemory& memory) const;
  void flushBatches(TileHits<Policy>& tile, CastingMemory& memory) const;

  template <typename Primitive>
  void test(const Primitive& primitive, std::uint32_t number, const Window& box,
    TileHits<Policy>& tile) const;

  const FrameMesh& Mesh;
  const CameraFrame& Frame;
  const TileGrid& Grid;
  const TriangleCasting<Policy> Triangles;
  const SphereCasting<Policy> Spheres;
  const LineCasting<Policy> Lines;
  const bool IsMixed; ///< the scene has transparent surfaces
};

extern template class Casting<Nearest>;
extern template class Casting<Layers>;
}

#endif
