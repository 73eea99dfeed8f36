// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bounds.h"

#include <vector>

namespace lambent
{
Bounds findBounds(const Surface& surface, const Parallel& parallel)
{
  constexpr std::size_t chunk = 16 * 1024;
  const std::size_t count = surface.corners.size;
  std::vector<Bounds> found(parallel.workers());
  forEach(parallel, 0, (count + chunk - 1) / chunk,
    [&](int worker, std::size_t i)
    {
      Bounds bounds;
      for (std::size_t corner = i * chunk; corner < std::min(count, (i + 1) * chunk); ++corner)
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
      found[worker].add(bounds);
    });
  Bounds all;
  for (const Bounds& bounds : found)
  {
    all.add(bounds);
  }
  return all;
}
}
