// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief streams the triangles past the samples, and bins each one in the tiles that it touches
 *
 * For each triangle, read the lattice positions of its three points. If no sample lies between
 * them, drop the triangle. Otherwise put it into the bins of the tiles that contain those samples.
 * A triangle that crosses the eye plane has no bounded projection and goes to all tiles. A triangle
 * wholly at or behind the eye plane is dropped.
 *
 * binPlainly() processes one triangle at a time and is the definition. Where the mesh allows it,
 * the kernel of LatticeKernel.h processes blocks of triangles instead. If a triangle has few
 * samples in its box, its certain hits are binned at once (Coverage.h), and its points are not read
 * again until it is shaded.
 */
#ifndef lambent_Binning_h
#define lambent_Binning_h

#include "Bins.h"
#include "Coverage.h"
#include "FrameMesh.h"
#include "LatticeKernel.h"
#include "PointLattice.h"

namespace lambent
{
/// The defects of a mesh that prevent drawing. Triangles are numbered over all surfaces.
struct MeshDefects
{
  /// The first triangle with a corner whose point does not exist.
  std::uint32_t wrongCorner = noTriangle;
  /// The number of cells with a point that is not finite, and the first triangle of such a cell.
  std::size_t notFinite = 0;
  std::uint32_t firstNotFinite = noTriangle;

  void merge(const MeshDefects& other)
  {
    this->wrongCorner = std::min(this->wrongCorner, other.wrongCorner);
    this->notFinite += other.notFinite;
    this->firstNotFinite = std::min(this->firstNotFinite, other.firstNotFinite);
  }
};

/// The triangles of one surface in a batch of LatticeBoxes.
struct BoxedPart
{
  const SceneMesh::Part* part;
  std::size_t begin;   ///< the first triangle, counted in its surface
  std::uint32_t first; ///< the place of the first triangle in the batch
  std::uint32_t end;   ///< the place after the last triangle
  std::int32_t offset; ///< from the surface's point numbers to places among the positions
};

/// A worker's results and scratch memory.
struct BinningMemory
{
  explicit BinningMemory(const TileGrid& grid)
    : bins(grid)
  {
  }

  Bins bins;
  MeshDefects defects;
  LatticeBoxes boxes;
  std::vector<BoxedPart> parts; ///< the surfaces of the boxes, in order
  /// Indexed by height - 1 and width - 1.
  SmallTriangles small[SmallTriangles::side][SmallTriangles::side];
  const SceneMesh::Part* part = nullptr; ///< surface of the last small triangle, if there is one
  bool isMixed = false;                  ///< the small triangles may be of several surfaces
  CoverageBatch batch;
  CoveredSamples covered;
};

class Binning
{
public:
  /// positions: one per point of the mesh. Without culling, every triangle goes to every tile.
  /// Kernels require culling.
  Binning(const FrameMesh& mesh, const PointLattice& lattice, const LatticePosition* positions,
    const TileGrid& grid, const Window& part, bool culling, bool kernels)
    : Mesh(mesh)
    , Frame(mesh.frame())
    , Lattice(lattice)
    , Positions(positions)
    , Grid(grid)
    , Part(part)
    , Culling(culling)
    , Kernels(culling && kernels)
  {
  }

  /// Bins the triangles [begin, end), counted over all surfaces. Some are held back until flush().
  void run(std::size_t begin, std::size_t end, BinningMemory& memory) const;
  void flush(BinningMemory& memory) const;

private:
  void add(
    const SceneMesh::Part& part, std::size_t begin, std::size_t end, BinningMemory& memory) const;
  void binBoxes(BinningMemory& memory) const;
  struct BoxedPartView;
  BoxedPartView viewOf(const BoxedPart& boxed) const;
  template <bool IsOnePart, typename Body>
  void forPlaces(
    const std::uint32_t* places, int count, const BinningMemory& memory, const Body& body) const;
  template <bool IsOnePart>
  void binFound(BinningMemory& memory) const;
  void binUnplaced(BinningMemory& memory) const;
  void binPlainly(const SceneMesh::Part& part, std::size_t triangle, BinningMemory& memory) const;
  void insert(std::uint32_t place, const BoxedPartView& view, BinningMemory& memory) const;
  void addSmall(const SmallTriangle& triangle, int width, int height, BinningMemory& memory) const;
  void flush(int width, int height, BinningMemory& memory) const;
  void load(int width, int height, BinningMemory& memory) const;
  bool isBehindEye(const TupleSpan& points, const std::uint64_t corners[3]) const;

  const FrameMesh& Mesh;
  const CameraFrame& Frame;
  const PointLattice& Lattice;
  const LatticePosition* Positions;
  const TileGrid& Grid;
  const Window Part;
  bool Culling;
  bool Kernels;
};
}

#endif
