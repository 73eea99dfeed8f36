// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DrawnTriangles.h"

#include "CellView.h"
#include "CheckedFaces.h"
#include "Chunks.h"

#include <atomic>

namespace lambent
{
namespace
{
constexpr std::size_t itemsPerChunk = 4096;

CellUse useOf(unsigned char flags)
{
  return flags & (GhostFlags::hiddenCell | GhostFlags::refinedCell) ? CellUse::None
    : flags & GhostFlags::duplicateCell                             ? CellUse::ForNormals
                                                                    : CellUse::Drawn;
}

/// Writes the uses of a list of cells. Returns whether some are not drawn.
bool findUses(const CellSpan& cells, std::size_t pointCount, const unsigned char* pointFlags,
  const unsigned char* cellFlags, const Parallel& parallel, CellUse* uses)
{
  std::atomic<bool> isSomeUndrawn{ false };
  const auto isHidden = [&](std::uint64_t point)
  { return point < pointCount && (pointFlags[point] & GhostFlags::hiddenPoint) != 0; };
  forEachChunk<itemsPerChunk>(parallel, cellCount(cells),
    [&](std::size_t begin, std::size_t end)
    {
      bool isUndrawn = false;
      for (std::size_t cell = begin; cell < end; ++cell)
      {
        uses[cell] = cellFlags ? useOf(cellFlags[cell]) : CellUse::Drawn;
        for (std::size_t k = cells.offsets[cell]; pointFlags && k < cells.offsets[cell + 1]; ++k)
        {
          uses[cell] = isHidden(cells.connectivity[k]) ? CellUse::None : uses[cell];
        }
        isUndrawn = isUndrawn || uses[cell] != CellUse::Drawn;
      }
      if (isUndrawn)
      {
        isSomeUndrawn = true;
      }
    });
  return isSomeUndrawn;
}
}

UnwrittenVector<CellUse> findCellUses(const CellSpan& polygons, const CellSpan& strips,
  std::size_t pointCount, const GhostFlags& ghosts, const Parallel& parallel)
{
  if (!ghosts.points && !ghosts.cells)
  {
    return {};
  }
  const std::size_t count = cellCount(polygons);
  UnwrittenVector<CellUse> uses(count + cellCount(strips));
  const bool ofPolygons = findUses(
    polygons, pointCount, ghosts.points, ghosts.cells, Share(parallel, 0.0, 0.5), uses.data());
  const bool ofStrips = findUses(strips, pointCount, ghosts.points,
    ghosts.cells ? ghosts.cells + count : nullptr, Share(parallel, 0.5, 1.0), uses.data() + count);
  return ofPolygons || ofStrips ? uses : UnwrittenVector<CellUse>();
}

void skipUnused(const UnwrittenVector<CellUse>& uses, CheckedFaces& faces)
{
  if (uses.empty())
  {
    return;
  }
  std::vector<unsigned char>& skip = faces.faces.skip;
  skip.resize(cellCount(faces.faces.cells));
  for (std::size_t face = 0; face < skip.size(); ++face)
  {
    const auto cell = static_cast<std::size_t>(faces.cellOf(static_cast<std::int64_t>(face)));
    skip[face] = skip[face] || uses[cell] == CellUse::None;
  }
}

DrawnTriangles::DrawnTriangles(std::size_t triangleCount, const std::int64_t* cells,
  std::int64_t firstCell, const UnwrittenVector<CellUse>& uses, bool isMirrored,
  const Parallel& parallel)
  : AreAll(uses.empty())
  , AreMirrored(isMirrored)
  , Count(triangleCount)
{
  if (this->AreAll)
  {
    return;
  }
  const auto cellOf = [&](std::size_t triangle)
  { return cells ? cells[triangle] : firstCell + static_cast<std::int64_t>(triangle); };
  const auto isDrawn = [&](std::size_t triangle)
  { return uses[static_cast<std::size_t>(cellOf(triangle) - firstCell)] == CellUse::Drawn; };
  // Where the triangles of each chunk begin among those kept.
  std::vector<std::size_t> first(chunkCount(triangleCount, itemsPerChunk) + 1, 0);
  forEachChunk<itemsPerChunk>(Share(parallel, 0.0, 0.5), triangleCount,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        first[begin / itemsPerChunk + 1] += isDrawn(t);
      }
    });
  for (std::size_t chunk = 1; chunk < first.size(); ++chunk)
  {
    first[chunk] += first[chunk - 1];
  }
  this->Count = first.back();
  this->Kept.resize(this->Count);
  this->Cells.resize(this->Count);
  forEachChunk<itemsPerChunk>(Share(parallel, 0.5, 1.0), triangleCount,
    [&](std::size_t begin, std::size_t end)
    {
      std::size_t out = first[begin / itemsPerChunk];
      for (std::size_t t = begin; t < end; ++t)
      {
        if (isDrawn(t))
        {
          this->Cells[out] = cellOf(t);
          this->Kept[out++] = t;
        }
      }
    });
}

template <typename Index>
void DrawnTriangles::pick(
  const void* all, const Parallel& parallel, UnwrittenVector<Index>& picked) const
{
  const auto* const indices = static_cast<const Index*>(all);
  const std::size_t second = this->AreMirrored ? 2 : 1, third = 3 - second;
  picked.resize(3 * this->Count);
  forEachChunk<itemsPerChunk>(parallel, this->Count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        const Index* const from = indices + 3 * (this->AreAll ? t : this->Kept[t]);
        picked[3 * t] = from[0];
        picked[3 * t + 1] = from[second];
        picked[3 * t + 2] = from[third];
      }
    });
}

UnwrittenVector<unsigned char> DrawnTriangles::pickEdges(
  const UnwrittenVector<unsigned char>& all, const Parallel& parallel) const
{
  // With the second and the third corner, the first edge and the last one are swapped.
  const auto swapped = [](unsigned int edges)
  { return (edges & 2u) | (edges & 1u) << 2 | (edges & 4u) >> 2; };
  UnwrittenVector<unsigned char> picked(this->AreAll ? all.size() : this->Count);
  forEachChunk<itemsPerChunk>(parallel, picked.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        const unsigned int edges = all[this->AreAll ? t : this->Kept[t]];
        picked[t] = static_cast<unsigned char>(this->AreMirrored ? swapped(edges) : edges);
      }
    });
  return picked;
}

DrawnTriangles::Indices DrawnTriangles::pick(const IndexSpan& all, const Parallel& parallel) const
{
  Indices result;
  if (all.is64Bit)
  {
    this->pick(all.data, parallel, result.Wide);
  }
  else
  {
    this->pick(all.data, parallel, result.Narrow);
  }
  return result;
}

IndexSpan DrawnTriangles::Indices::span() const
{
  return this->Wide.empty() ? IndexSpan{ this->Narrow.data(), false, this->Narrow.size() }
                            : IndexSpan{ this->Wide.data(), true, this->Wide.size() };
}
}
