// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SphereCasting.h"

#include "FlushBatch.h"
#include "SphereCastingKernel.h"

#include <hwy/cache_control.h>

namespace lambent
{
template <typename Policy>
void SphereCasting<Policy>::cast(
  const NextPrimitive* spheres, int count, TileHits<Policy>& tile, SphereBatch& batch) const
{
  for (int k = 0; k < count; ++k)
  {
    const SceneMesh::Part& part = *spheres[k].part;
    hwy::Prefetch(part.points().at(part.sphereOf(spheres[k].waiting->number)));
  }
  for (int k = 0; k < count; ++k)
  {
    this->add(spheres[k], tile, batch);
  }
}

template <typename Policy>
void SphereCasting<Policy>::add(
  const NextPrimitive& sphere, TileHits<Policy>& tile, SphereBatch& batch) const
{
  const SceneMesh::Part& part = *sphere.part;
  const std::size_t point = part.sphereOf(sphere.waiting->number);
  const Vec3 center = part.points()[point];
  batch.centers[0][batch.count] = center.x;
  batch.centers[1][batch.count] = center.y;
  batch.centers[2][batch.count] = center.z;
  batch.radii[batch.count] = part.surface->radiusOf(point);
  batch.spheres[batch.count] = sphere.waiting->number;
  batch.boxes[batch.count] = sphere.waiting->box;
  batch.nearest[batch.count] = sphere.waiting->nearest;
  batch.hasOutside[batch.count] = part.hasOutside(sphere.waiting->number);
  batch.hasInside[batch.count] = part.hasInside(sphere.waiting->number);
  if (++batch.count == SphereBatch::capacity)
  {
    this->flush(tile, batch);
  }
}

template <typename Policy>
void SphereCasting<Policy>::flush(TileHits<Policy>& tile, SphereBatch& batch) const
{
  flushBatch(this->Mesh, tile, batch);
}

template class SphereCasting<Nearest>;
template class SphereCasting<Layers>;
}
