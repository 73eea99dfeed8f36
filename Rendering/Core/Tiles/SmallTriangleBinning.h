// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief bins the certain hits of small triangles
 *
 * Triangles with few samples in their box wait in queues, one for each size of box. A full queue
 * goes through the kernel of Coverage.h. Its certain hits are binned at once; a ray that it leaves
 * uncertain is cast exactly. The points of the triangles are not read again until they are shaded.
 */
#ifndef lambent_SmallTriangleBinning_h
#define lambent_SmallTriangleBinning_h

#include "BinningResult.h"
#include "Coverage.h"
#include "FrameMesh.h"

namespace lambent
{
/// A worker's queues and scratch memory.
struct SmallTriangleMemory
{
  /// Indexed by height - 1 and width - 1.
  SmallTriangles queues[SmallTriangles::side][SmallTriangles::side];
  const SceneMesh::Part* part = nullptr; ///< surface of the last triangle, if there is one
  bool isMixed = false;                  ///< the triangles may be of several surfaces
  CoverageBatch batch;
  CoveredSamples covered;

  /// Call before adding triangles of a surface and, unless it is the only one, of others.
  void begin(const SceneMesh::Part& next, bool isOnly)
  {
    this->isMixed = this->isMixed || !isOnly || (this->part && this->part != &next);
    this->part = &next;
  }
};

class SmallTriangleBinning
{
public:
  SmallTriangleBinning(const FrameMesh& mesh, const PointLattice& lattice, const Window& part)
    : Mesh(mesh)
    , Frame(mesh.frame())
    , Lattice(lattice)
    , Part(part)
  {
  }

  /// Adds a triangle to the queue for boxes of width x height samples.
  void add(const SmallTriangle& triangle, int width, int height, SmallTriangleMemory& memory,
    BinningResult& result) const
  {
    SmallTriangles& queue = memory.queues[height - 1][width - 1];
    queue.items[queue.count++] = triangle;
    if (queue.count == SmallTriangles::capacity)
    {
      this->flush(width, height, memory, result);
    }
  }

  /// Bins all triangles that are waiting.
  void flush(SmallTriangleMemory& memory, BinningResult& result) const;

private:
  void flush(int width, int height, SmallTriangleMemory& memory, BinningResult& result) const;
  void load(int width, int height, SmallTriangleMemory& memory) const;

  const FrameMesh& Mesh;
  const CameraFrame& Frame;
  const PointLattice& Lattice;
  const Window Part;
};
}

#endif
