// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TilePlan.h"

#include <algorithm>

namespace lambent
{
namespace
{
// A tile with more than pagesToSplit pages is split, into at most maximumShares tasks.
constexpr std::size_t pagesToSplit = 128;
constexpr std::size_t maximumShares = 32;

// Neighbouring tiles go to the same worker: their pixels share cache lines, which two workers would
// keep taking from each other.
constexpr std::size_t mostTilesInGroup = 16;
constexpr std::size_t mostWeightInGroup = 128;

// The weight of a batch, in pages; painting this many samples counts as one more. A batch takes
// some milliseconds, so that progress and aborts are handled promptly.
constexpr std::size_t mostWeightInBatch = 8 * 1024;
constexpr std::size_t emptyTileWeight = 2;
constexpr std::size_t samplesInWeight = 256;
}

std::size_t TilePlan::countPages(const std::vector<const Bins*>& bins, int tile) const
{
  std::size_t count = 0;
  forBins(this->Grid, bins, tile,
    [&](const Bins& all, const TileGrid::Level& level, int bin)
    {
      count += all.primitives().pageCount(bin);
      count += this->Grid.isFinest(level) ? all.hits().pageCount(bin) : 0;
    });
  return count;
}

void TilePlan::make(const std::vector<const Bins*>& bins)
{
  this->Tasks.clear();
  this->Splits.clear();
  this->Groups.assign(1, 0);
  this->Batches.assign(1, 0);
  const auto size = static_cast<std::size_t>(this->Grid.levels()[0].size);
  const std::size_t paintingWeight = size * size / samplesInWeight;
  std::size_t groupWeight = 0, groupTiles = 0, batchWeight = 0;
  for (int tile = 0; tile < this->Grid.tileCount(); ++tile)
  {
    const std::size_t pages = this->countPages(bins, tile);
    const std::size_t shares = this->sharesFor(pages);
    const std::size_t weight = pages + emptyTileWeight;
    if (shares > 1 || groupTiles == mostTilesInGroup || groupWeight > mostWeightInGroup)
    {
      this->endGroup();
      groupWeight = groupTiles = 0;
    }
    if (batchWeight > mostWeightInBatch)
    {
      this->endBatch();
      groupWeight = groupTiles = batchWeight = 0;
    }
    groupWeight += weight;
    batchWeight += weight + (pages > 0 ? paintingWeight : 0);
    ++groupTiles;
    if (shares > 1)
    {
      this->addShares(tile, shares);
    }
    else
    {
      this->Tasks.push_back({ tile, 0, static_cast<int>(shares), -1 });
    }
  }
  this->endBatch();
}

/// Makes each share of a split tile a group of its own.
void TilePlan::addShares(int tile, std::size_t shares)
{
  const auto count = static_cast<int>(shares);
  for (int share = 0; share < count; ++share)
  {
    this->Tasks.push_back({ tile, share, count, static_cast<int>(this->Splits.size()) });
    this->endGroup();
  }
  this->Splits.push_back({ tile, count });
}

void TilePlan::endGroup()
{
  if (this->Groups.back() != this->Tasks.size())
  {
    this->Groups.push_back(this->Tasks.size());
  }
}

void TilePlan::endBatch()
{
  this->endGroup();
  if (this->Batches.back() != this->Groups.size() - 1)
  {
    this->Batches.push_back(this->Groups.size() - 1);
  }
}

/// The number of tasks for a tile; 0 if it has no pages.
std::size_t TilePlan::sharesFor(std::size_t pages) const
{
  return this->Workers > 1 && pages > pagesToSplit
    ? std::min({ pages / (pagesToSplit / 4), 4 * this->Workers, maximumShares })
    : std::min<std::size_t>(pages, 1);
}
}
