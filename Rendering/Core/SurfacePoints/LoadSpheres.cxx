// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LoadSpheres.h"

#include <hwy/cache_control.h>

#include <algorithm>

namespace lambent
{
void loadSpheres(const RunRange& range, SampleBatch& batch)
{
  std::fill_n(batch.isWanted, batch.runCount, 0.0);
  // Centres are scattered in memory, so all are prefetched before any is read.
  for (int run = range.firstRun; run < range.endRun; ++run)
  {
    if (batch.primitives[run] != noPrimitive)
    {
      const SceneMesh::Part& part = *batch.parts[run];
      hwy::Prefetch(part.points().at(part.sphereOf(batch.primitives[run])));
    }
  }
  for (int run = range.firstRun; run < range.endRun; ++run)
  {
    if (batch.primitives[run] == noPrimitive)
    {
      continue;
    }
    const SceneMesh::Part& part = *batch.parts[run];
    const std::size_t sphere = part.sphereOf(batch.primitives[run]);
    const Vec3 center = part.points()[sphere];
    batch.isWanted[run] = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      batch.points[SphereRows::center + axis][run] = center[axis];
    }
    batch.points[SphereRows::radius][run] = part.surface->radiusOf(sphere);
    batch.points[SphereRows::hasOutside][run] = part.hasOutside(batch.primitives[run]) ? 1.0 : 0.0;
  }
}
}
