// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleCasting.h"

#include "CastingKernel.h"
#include "FlushBatch.h"

#include <hwy/cache_control.h>

namespace lambent
{
template <typename Policy>
void TriangleCasting<Policy>::cast(
  const NextPrimitive* triangles, int count, TileHits<Policy>& tile, TriangleBatch& batch) const
{
  Corners corners[atOnce];
  this->fetch(triangles, count, corners);
  for (int k = 0; k < count; ++k)
  {
    this->add(triangles[k], corners[k], tile, batch);
  }
}

// Points are scattered in memory, so many are prefetched before the first is read.
template <typename Policy>
void TriangleCasting<Policy>::fetch(
  const NextPrimitive* triangles, int count, Corners* corners) const
{
  for (int k = 0; k < count; ++k)
  {
    const SceneMesh::Part& part = *triangles[k].part;
    const std::size_t first = 3 * (triangles[k].waiting->number - part.firstPrimitive);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      corners[k][corner] = part.corners()[first + corner];
      hwy::Prefetch(part.points().at(corners[k][corner]));
    }
  }
}

template <typename Policy>
void TriangleCasting<Policy>::add(const NextPrimitive& triangle, const Corners& corners,
  TileHits<Policy>& tile, TriangleBatch& batch) const
{
  const SceneMesh::Part& part = *triangle.part;
  for (int corner = 0; corner < 3; ++corner)
  {
    const Vec3 p = part.points()[corners[corner]];
    batch.points[3 * corner][batch.count] = p.x;
    batch.points[3 * corner + 1][batch.count] = p.y;
    batch.points[3 * corner + 2][batch.count] = p.z;
  }
  batch.triangles[batch.count] = triangle.waiting->number;
  batch.boxes[batch.count] = triangle.waiting->box;
  batch.cullFront[batch.count] = part.appearance->cullFront;
  batch.cullBack[batch.count] = part.appearance->cullBack;
  if (++batch.count == TriangleBatch::capacity)
  {
    this->flush(tile, batch);
  }
}

template <typename Policy>
void TriangleCasting<Policy>::flush(TileHits<Policy>& tile, TriangleBatch& batch) const
{
  flushBatch(this->Mesh, tile, batch);
}

template class TriangleCasting<Nearest>;
template class TriangleCasting<Layers>;
}
