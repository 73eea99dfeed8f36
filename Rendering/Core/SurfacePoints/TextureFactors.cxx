// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TextureFactors.h"

#include <hwy/cache_control.h>

namespace lambent
{
TextureColor textureAt(const Surface& surface, std::size_t triangle, const Vec3& weights)
{
  const TextureMap& map = *surface.texture;
  const auto components = static_cast<std::size_t>(map.coordinates.components);
  return map.coordinates.visit(
    [&](const auto* all)
    {
      const auto corner = [&](std::size_t k)
      { return all + components * surface.corners[3 * triangle + k]; };
      const auto *const a = corner(0), *const b = corner(1), *const c = corner(2);
      const auto at = [&](std::size_t k)
      {
        return (static_cast<double>(a[k]) * weights.x + static_cast<double>(b[k]) * weights.y) +
          static_cast<double>(c[k]) * weights.z;
      };
      TextureColor color = map.texture.sample(at(0), components > 1 ? at(1) : 0.0);
      color.alpha = map.texture.hasAlpha ? color.alpha : 1.0;
      return color;
    });
}

void multiplyByTextures(const RunRange& range, SampleBatch& batch)
{
  for (int run = range.firstRun; run < range.endRun; ++run)
  {
    if (batch.primitives[run] == noPrimitive)
    {
      continue;
    }
    // Coordinates are scattered in memory, so all are prefetched before any is read.
    const SceneMesh::Part& part = *batch.parts[run];
    const std::size_t first = 3 * (batch.primitives[run] - part.firstPrimitive);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      hwy::Prefetch(part.surface->texture->coordinates.address(part.corners()[first + corner]));
    }
  }
  for (int place = range.first; place < range.end; ++place)
  {
    const std::int64_t run = batch.run[place];
    const bool isSample =
      place % SampleBatch::pieceSize < batch.pieces[place / SampleBatch::pieceSize].width;
    if (!isSample || batch.primitives[run] == noPrimitive)
    {
      continue;
    }
    const SceneMesh::Part& part = *batch.parts[run];
    const Vec3 weights(batch.weights[0][place], batch.weights[1][place], batch.weights[2][place]);
    const TextureColor factor =
      textureAt(*part.surface, batch.primitives[run] - part.firstPrimitive, weights);
    batch.textureAlphas[place] = factor.alpha;
    for (int channel = 0; channel < 3; ++channel)
    {
      batch.colors[channel][place] *= factor.color[channel];
    }
  }
}
}
