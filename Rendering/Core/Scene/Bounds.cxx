// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bounds.h"

#include "Chunks.h"
#include "SceneMesh.h"

#include <vector>

namespace lambent
{
Bounds findBounds(const std::vector<Surface>& surfaces, const Parallel& parallel)
{
  constexpr std::size_t primitivesPerChunk = 8 * 1024;
  const SceneMesh mesh(surfaces);
  const std::size_t count = mesh.primitiveCount();
  std::vector<Bounds> found(chunkCount(count, primitivesPerChunk));
  forEachChunk<primitivesPerChunk>(parallel, count,
    [&](std::size_t begin, std::size_t end)
    {
      Bounds& bounds = found[begin / primitivesPerChunk];
      const auto add = [&bounds](const Vec3& point)
      {
        if (isFinite(point))
        {
          bounds.add(point);
        }
      };
      mesh.forPrimitives(begin, end,
        [&](const SceneMesh::Part& part, std::size_t from, std::size_t to)
        { part.surface->forBoundingPoints(from, to, add); });
    });
  Bounds all;
  for (const Bounds& bounds : found)
  {
    all.add(bounds);
  }
  return all;
}
}
