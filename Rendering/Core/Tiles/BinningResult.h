// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the result of a worker's binning: its bins, and the defects of the mesh
 */
#ifndef lambent_BinningResult_h
#define lambent_BinningResult_h

#include "Bins.h"
#include "Surface.h"

namespace lambent
{
/// The defects of a mesh that prevent drawing. Primitives are numbered over all surfaces.
struct MeshDefects
{
  /// The first primitive with a corner whose point does not exist.
  std::uint32_t wrongCorner = noPrimitive;
  /// The number of cells with a point that is not finite, and the first primitive of such a cell.
  std::size_t notFinite = 0;
  std::uint32_t firstNotFinite = noPrimitive;

  void merge(const MeshDefects& other)
  {
    this->wrongCorner = std::min(this->wrongCorner, other.wrongCorner);
    this->notFinite += other.notFinite;
    this->firstNotFinite = std::min(this->firstNotFinite, other.firstNotFinite);
  }
};

struct BinningResult
{
  /// workers: how many share the primitives.
  BinningResult(const TileGrid& grid, int workers)
    : bins(grid)
    , shallowArea(
        2 * static_cast<std::int64_t>(grid.whole().width()) * grid.whole().height() / workers)
  {
  }

  Bins bins;
  /// Bounds on nearness cost time, and are useful only in a scene of many layers. So they are not
  /// computed before boxes with this total area have been binned, in samples: two layers.
  std::int64_t shallowArea;
  MeshDefects defects;
};
}

#endif
