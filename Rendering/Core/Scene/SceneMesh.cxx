// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneMesh.h"

#include <utility>

namespace lambent
{
namespace
{
constexpr std::size_t blockSize = 4096;

/// Prefetches a surface, because the processor's own prefetching does not keep up.
void prefetch(const Surface& surface)
{
  for (std::size_t byte = 0; byte < sizeof(Surface); byte += 64)
  {
    hwy::Prefetch(reinterpret_cast<const char*>(&surface) + byte);
  }
}
}

// There may be as many surfaces as primitives, so that reading them takes long.
SceneMesh::SceneMesh(const std::vector<Surface>& surfaces, const Parallel& parallel)
{
  this->Parts.resize(surfaces.size() + 1);
  std::vector<Block> blocks;
  for (std::size_t begin = 0; begin < surfaces.size(); begin += blockSize)
  {
    blocks.push_back({ begin, std::min(begin + blockSize, surfaces.size()) });
  }
  forEach(parallel, 0, blocks.size(), [&](int, std::size_t k) { this->read(surfaces, blocks[k]); });
  this->join(blocks);
  forEach(parallel, 0, blocks.size(), [&](int, std::size_t k) { this->number(blocks[k]); });
}

/// Counts primitives and points within the block, and compares appearances within it.
void SceneMesh::read(const std::vector<Surface>& surfaces, Block& block)
{
  const Appearance* appearance = &surfaces[block.begin].appearance;
  block.first = appearance;
  for (std::size_t k = block.begin; k < block.end; ++k)
  {
    const Surface& surface = surfaces[k];
    prefetch(surfaces[std::min(k + 8, surfaces.size() - 1)]);
    appearance = surface.appearance.isSameAs(*appearance) ? appearance : &surface.appearance;
    this->Parts[k] = Part(surface, *appearance, block.primitives, block.points);
    block.primitives += this->Parts[k].primitiveCount;
    block.points += surface.points.size;
    block.hasOnlyTriangles =
      block.hasOnlyTriangles && this->Parts[k].kind() == PrimitiveKind::Triangle;
    block.hasTransparency = block.hasTransparency || this->Parts[k].isTransparent();
    block.hasVaryingOpacity =
      block.hasVaryingOpacity || (surface.colors && surface.colors->hasAlpha);
  }
  block.last = appearance;
}

/// Counts over all blocks, and compares appearances where one block ends and the next begins.
void SceneMesh::join(std::vector<Block>& blocks)
{
  const Appearance* previous = nullptr;
  for (Block& block : blocks)
  {
    this->Primitives += std::exchange(block.primitives, this->Primitives);
    this->Points += std::exchange(block.points, this->Points);
    this->HasOnlyTriangles = this->HasOnlyTriangles && block.hasOnlyTriangles;
    this->HasTransparency = this->HasTransparency || block.hasTransparency;
    this->HasVaryingOpacity = this->HasVaryingOpacity || block.hasVaryingOpacity;
    block.replacement = previous && block.first->isSameAs(*previous) ? previous : block.first;
    previous = block.last == block.first ? block.replacement : block.last;
  }
  Part& end = this->Parts.back();
  end = Part();
  end.firstPrimitive = static_cast<std::uint32_t>(this->Primitives);
  end.firstPoint = this->Points;
  while (this->Primitives >> this->Shift > 2 * this->Parts.size())
  {
    ++this->Shift;
  }
  const std::size_t step = std::size_t(1) << this->Shift;
  this->FirstParts.resize((this->Primitives + step - 1) / step);
}

/// Numbers primitives and points over all surfaces.
void SceneMesh::number(const Block& block)
{
  const std::size_t step = std::size_t(1) << this->Shift;
  for (std::size_t k = block.begin; k < block.end; ++k)
  {
    Part& part = this->Parts[k];
    part.firstPrimitive += static_cast<std::uint32_t>(block.primitives);
    part.firstPoint += block.points;
    part.appearance = part.appearance == block.first ? block.replacement : part.appearance;
    const std::size_t first = part.firstPrimitive, end = first + part.primitiveCount;
    for (std::size_t entry = (first + step - 1) / step; entry * step < end; ++entry)
    {
      this->FirstParts[entry] = static_cast<std::uint32_t>(k);
    }
  }
}
}
