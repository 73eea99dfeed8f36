// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief stream the triangles past the rays, and give each to the cells it touches
 *
 * Per triangle: read the lattice positions of its three points; if no ray lies
 * between them it is gone; otherwise it goes into the bins of the cells that those
 * rays belong to. A triangle that the eye plane crosses has no bounded projection
 * and goes to all cells; one wholly at or behind the eye plane is dropped.
 *
 * binPlainly() takes one triangle after the other and is the definition; where the
 * mesh allows it, blocks of triangles go through the kernel of LatticeKernel.h.
 */
#ifndef lambent_Binning_h
#define lambent_Binning_h

#include "Bins.h"
#include "Mesh.h"
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

class Binning
{
public:
  /// positions: one for each point of the mesh. Without culling every triangle
  /// goes to every cell.
  Binning(const Mesh& mesh, const CameraFrame& frame, const PointLattice& lattice,
    const LatticePosition* positions, const CellGrid& grid, bool culling, bool kernels)
    : Triangles(mesh)
    , Frame(frame)
    , Lattice(lattice)
    , Positions(positions)
    , Grid(grid)
    , Culling(culling)
    , Kernels(culling && kernels)
  {
  }

  /// Bin the triangles [begin, end), counted over all surfaces.
  void run(std::size_t begin, std::size_t end, Bins& bins, MeshDefects& defects) const;

private:
  void bin(const Mesh::Part& part, std::size_t begin, std::size_t end, Bins& bins,
    MeshDefects& defects) const;
  void binPlainly(
    const Mesh::Part& part, std::size_t triangle, Bins& bins, MeshDefects& defects) const;
  bool isBehindEye(const TupleSpan& points, const std::uint64_t corners[3]) const;

  const Mesh& Triangles;
  const CameraFrame& Frame;
  const PointLattice& Lattice;
  const LatticePosition* Positions;
  const CellGrid& Grid;
  bool Culling;
  bool Kernels;
};
}

#endif
