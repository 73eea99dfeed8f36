// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief stream the triangles past the rays, and give each to the tiles it touches
 *
 * Per triangle: read the lattice positions of its three points; if no ray lies
 * between them it is gone; otherwise it goes into the bins of the tiles that those
 * rays belong to. A triangle that the eye plane crosses has no bounded projection
 * and goes to all tiles; one wholly at or behind the eye plane is dropped.
 *
 * binPlainly() takes one triangle after the other and is the definition. Where the
 * mesh allows it, blocks of triangles go through the kernel of LatticeKernel.h
 * instead, and of those with few rays the certain hits are binned at once, see
 * Coverage.h; their points are then not looked at again until they are shaded.
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
/// What a mesh has that cannot be drawn. Numbers are those of triangles, counted
/// over all surfaces.
struct MeshDefects
{
  /// The first triangle with a corner that names a point that does not exist.
  std::uint32_t wrongCorner = noTriangle;
  /// Cells with a point that is not finite: their number, and the first triangle.
  std::size_t notFinite = 0;
  std::uint32_t firstNotFinite = noTriangle;

  void merge(const MeshDefects& other)
  {
    this->wrongCorner = std::min(this->wrongCorner, other.wrongCorner);
    this->notFinite += other.notFinite;
    this->firstNotFinite = std::min(this->firstNotFinite, other.firstNotFinite);
  }
};

/// Triangles of one surface among those whose boxes are found together.
struct BoxedPart
{
  const SceneMesh::Part* part;
  std::size_t begin;   ///< the first of the triangles in its surface
  std::uint32_t first; ///< the place of that
  std::uint32_t end;   ///< the place after the last
  std::int32_t offset; ///< from the surface's points to places among the positions
};

/// What a worker fills, and what it needs for that.
struct BinningMemory
{
  explicit BinningMemory(const TileGrid& grid)
    : bins(grid)
  {
  }

  Bins bins;
  MeshDefects defects;
  LatticeBoxes boxes;
  std::vector<BoxedPart> parts; ///< of the boxes, in order
  /// By height - 1 and width - 1.
  SmallTriangles small[SmallTriangles::side][SmallTriangles::side];
  const SceneMesh::Part* part = nullptr; ///< of the last small triangle, if there is any
  bool isMixed = false;                  ///< others are of other parts
  CoverageBatch batch;
  CoveredRays covered;
};

class Binning
{
public:
  /// positions: one for each point of the mesh. Without culling every triangle
  /// goes to every tile; kernels need culling.
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

  /// Bin the triangles [begin, end), counted over all surfaces. Some are kept back
  /// until flush().
  void run(std::size_t begin, std::size_t end, BinningMemory& memory) const;
  void flush(BinningMemory& memory) const;

private:
  void add(
    const SceneMesh::Part& part, std::size_t begin, std::size_t end, BinningMemory& memory) const;
  void binBoxes(BinningMemory& memory) const;
  template <bool IsOnePart>
  void binFound(BinningMemory& memory) const;
  void binUnplaced(BinningMemory& memory) const;
  void binPlainly(const SceneMesh::Part& part, std::size_t triangle, BinningMemory& memory) const;
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
