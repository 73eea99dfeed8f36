// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief finds the samples that triangles may cover, and bins each triangle in their tiles
 *
 * For each triangle, read the lattice positions of its three points. If no sample lies between
 * them, drop the triangle. Otherwise put it into the bins of the tiles that contain those samples.
 * A triangle that crosses the eye plane has no bounded projection and goes to all tiles. A triangle
 * wholly at or behind the eye plane is dropped.
 *
 * binPlainly() processes one triangle at a time and is the definition. Where the mesh allows it,
 * the kernel of LatticeKernel.h processes blocks of triangles instead. If a triangle has few
 * samples in its box, its certain hits are binned at once (SmallTriangleBinning.h).
 */
#ifndef lambent_TriangleBinning_h
#define lambent_TriangleBinning_h

#include "LatticeKernel.h"
#include "SmallTriangleBinning.h"

#include <vector>

namespace lambent
{
/// The triangles of one surface in a batch of LatticeBoxes.
struct BoxedPart
{
  const SceneMesh::Part* part;
  std::size_t begin;   ///< the first triangle, counted in its surface
  std::uint32_t first; ///< the place of the first triangle in the batch
  std::uint32_t end;   ///< the place after the last triangle
  std::int32_t offset; ///< from the surface's point numbers to places among the positions
};

/// A worker's scratch memory.
struct TriangleBinningMemory
{
  LatticeBoxes boxes;
  std::vector<BoxedPart> parts; ///< the surfaces of the boxes, in order
  SmallTriangleMemory small;
};

class TriangleBinning
{
public:
  /// As for Binning.
  TriangleBinning(const FrameMesh& mesh, const PointLattice& lattice,
    const LatticePosition* positions, const TileGrid& grid, const Window& part, bool culling,
    bool kernels)
    : Frame(mesh.frame())
    , Lattice(lattice)
    , Positions(positions)
    , Grid(grid)
    , Culling(culling)
    , Kernels(culling && kernels)
    , Small(mesh, lattice, part)
  {
  }

  /// Bins the triangles [begin, end) of a surface, counted in the surface. Some are held back until
  /// binBoxes(), and small ones until flush().
  void add(const SceneMesh::Part& part, std::size_t begin, std::size_t end,
    TriangleBinningMemory& memory, BinningResult& result) const;
  void binBoxes(TriangleBinningMemory& memory, BinningResult& result) const;
  void flush(TriangleBinningMemory& memory, BinningResult& result) const
  {
    this->Small.flush(memory.small, result);
  }

private:
  void addBatch(const SceneMesh::Part& part, std::size_t begin, std::size_t end,
    TriangleBinningMemory& memory, BinningResult& result) const;
  struct BoxedPartView;
  BoxedPartView viewOf(const BoxedPart& boxed) const;
  template <bool IsOnePart, typename Body>
  void forPlaces(const std::uint32_t* places, int count, const TriangleBinningMemory& memory,
    const Body& body) const;
  template <bool IsOnePart>
  void binFound(TriangleBinningMemory& memory, BinningResult& result) const;
  void binUnplaced(TriangleBinningMemory& memory, BinningResult& result) const;
  void binPlainly(const SceneMesh::Part& part, std::size_t triangle, BinningResult& result) const;
  void insert(std::uint32_t place, const BoxedPartView& view, const TriangleBinningMemory& memory,
    BinningResult& result) const;
  float nearnessBound(
    std::uint32_t place, const BoxedPartView& view, const LatticeBoxes& boxes) const;
  bool isBehindEye(const TupleSpan& points, const std::uint64_t corners[3]) const;

  const CameraFrame& Frame;
  const PointLattice& Lattice;
  const LatticePosition* Positions;
  const TileGrid& Grid;
  bool Culling;
  bool Kernels;
  const SmallTriangleBinning Small;
};
}

#endif
