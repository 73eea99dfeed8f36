// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bounds.h"

#include "Chunks.h"
#include "SceneMesh.h"

#include <vector>

namespace lambent
{
namespace
{
void addCorners(const Surface& surface, std::size_t begin, std::size_t end, Bounds& bounds)
{
  for (std::size_t corner = 3 * begin; corner < 3 * end; ++corner)
  {
    const std::uint64_t id = surface.corners[corner];
    if (id < surface.points.size)
    {
      const Vec3 p = surface.points[id];
      if (isFinite(p))
      {
        bounds.add(p);
      }
    }
  }
}
}

Bounds findBounds(const std::vector<Surface>& surfaces, const Parallel& parallel)
{
  constexpr std::size_t trianglesPerChunk = 8 * 1024;
  const SceneMesh mesh(surfaces);
  const std::size_t count = mesh.triangleCount();
  std::vector<Bounds> found(chunkCount(count, trianglesPerChunk));
  forEachChunk<trianglesPerChunk>(parallel, count,
    [&](std::size_t begin, std::size_t end)
    {
      mesh.forTriangles(begin, end,
        [&](const SceneMesh::Part& part, std::size_t from, std::size_t to)
        { addCorners(*part.surface, from, to, found[begin / trianglesPerChunk]); });
    });
  Bounds all;
  for (const Bounds& bounds : found)
  {
    all.add(bounds);
  }
  return all;
}
}
