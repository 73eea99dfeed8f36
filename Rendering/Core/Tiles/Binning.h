// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief streams the primitives past the samples, and bins each one in the tiles that it touches
 *
 * The primitives of a surface are all of one kind. Each kind has a class that puts them into the
 * bins of the tiles whose rays they may hit: TriangleBinning, SphereBinning and LineBinning. It may
 * keep too many tiles, never too few, and may bin a certain hit instead of the primitive.
 */
#ifndef lambent_Binning_h
#define lambent_Binning_h

#include "LineBinning.h"
#include "SphereBinning.h"
#include "TriangleBinning.h"

namespace lambent
{
/// A worker's results and scratch memory.
struct BinningMemory
{
  BinningMemory(const TileGrid& grid, int workers)
    : result(grid, workers)
  {
  }

  BinningResult result;
  TriangleBinningMemory triangles;
  SphereBoxes spheres;
};

class Binning
{
public:
  /// positions: one per point of the mesh, defined for those of triangles. Without culling, every
  /// primitive goes to every tile. Kernels require culling.
  Binning(const FrameMesh& mesh, const PointLattice& lattice, const LatticePosition* positions,
    const TileGrid& grid, const Window& part, bool culling, bool kernels)
    : Mesh(mesh.mesh())
    , Triangles(mesh, lattice, positions, grid, part, culling, kernels)
    , Spheres(mesh, lattice, grid, culling)
    , Lines(mesh, lattice, grid, culling)
  {
  }

  /// Bins the primitives [begin, end), counted over all surfaces. Some are held back until flush().
  void run(std::size_t begin, std::size_t end, BinningMemory& memory) const
  {
    this->Mesh.forPrimitives(begin, end,
      [&](const SceneMesh::Part& part, std::size_t from, std::size_t to)
      {
        switch (part.kind())
        {
          case PrimitiveKind::Triangle:
            this->Triangles.add(part, from, to, memory.triangles, memory.result);
            break;
          case PrimitiveKind::Sphere:
            this->Spheres.add(part, from, to, memory.spheres, memory.result);
            break;
          case PrimitiveKind::Line:
            this->Lines.add(part, from, to, memory.result);
        }
      });
    this->Triangles.binBoxes(memory.triangles, memory.result);
  }
  void flush(BinningMemory& memory) const
  {
    this->Triangles.flush(memory.triangles, memory.result);
  }

private:
  const SceneMesh& Mesh;
  const TriangleBinning Triangles;
  const SphereBinning Spheres;
  const LineBinning Lines;
};
}

#endif
