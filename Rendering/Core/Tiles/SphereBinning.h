// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief finds the samples that spheres may cover, and bins each sphere in their tiles
 *
 * The kernel of SphereBoxKernel.h finds a box of samples for each sphere. A sphere without samples,
 * or behind the eye, is dropped. Where there are no boxes, a sphere goes to all tiles. A sphere
 * whose radius is not positive is not drawn.
 */
#ifndef lambent_SphereBinning_h
#define lambent_SphereBinning_h

#include "BinningResult.h"
#include "FrameMesh.h"
#include "SphereBoxKernel.h"

namespace lambent
{
class SphereBinning
{
public:
  /// As for Binning.
  SphereBinning(
    const FrameMesh& mesh, const PointLattice& lattice, const TileGrid& grid, bool culling)
    : Frame(mesh.frame())
    , Lattice(lattice)
    , Grid(grid)
    , HasBoxes(culling && haveSphereBoxes(lattice))
  {
  }

  /// Bins the primitives [begin, end) of a surface of spheres, counted in the surface.
  void add(const SceneMesh::Part& part, std::size_t begin, std::size_t end, SphereBoxes& boxes,
    BinningResult& result) const;

private:
  void insert(const SceneMesh::Part& part, std::size_t primitive, const SphereBoxes& boxes,
    int place, BinningResult& result) const;

  const CameraFrame& Frame;
  const PointLattice& Lattice;
  const TileGrid& Grid;
  bool HasBoxes;
};
}

#endif
