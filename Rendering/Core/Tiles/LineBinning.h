// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief finds the samples that lines may cover, and bins each line in their tiles
 *
 * The bounds of LineBounds.h become a box of samples. A line without samples, or behind the eye, is
 * dropped. Where positions are not precise, a line goes to all tiles.
 */
#ifndef lambent_LineBinning_h
#define lambent_LineBinning_h

#include "BinningResult.h"
#include "FrameMesh.h"
#include "PointLattice.h"

namespace lambent
{
class LineBinning
{
public:
  /// As for Binning.
  LineBinning(
    const FrameMesh& mesh, const PointLattice& lattice, const TileGrid& grid, bool culling)
    : Mesh(mesh)
    , Lattice(lattice)
    , Grid(grid)
    , HasBoxes(culling && lattice.isPrecise())
  {
  }

  /// Bins the lines [begin, end) of a surface, counted in the surface.
  void add(
    const SceneMesh::Part& part, std::size_t begin, std::size_t end, BinningResult& result) const;

private:
  void insert(std::uint32_t number, const FrameLine& line, BinningResult& result) const;

  const FrameMesh& Mesh;
  const PointLattice& Lattice;
  const TileGrid& Grid;
  bool HasBoxes;
};
}

#endif
