// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TileTasks.h"

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

// The weight of a batch, in pages; an empty tile counts as a few. A batch takes some milliseconds,
// so that progress and aborts are handled promptly.
constexpr std::size_t mostWeightInBatch = 8 * 1024;
constexpr std::size_t emptyTileWeight = 2;

/// Calls body(bins, level, bin) for the bins of a tile and of the coarser tiles above it.
template <typename Body>
void forBins(const TileGrid& grid, const std::vector<const Bins*>& bins, int tile, Body&& body)
{
  const Window samples = grid.window(tile);
  for (const TileGrid::Level& level : grid.levels())
  {
    for (const Bins* workerBins : bins)
    {
      body(*workerBins, level, level.tileAt(samples.i0, samples.j0));
    }
  }
}
}

std::size_t TileTasks::countPages(const std::vector<const Bins*>& bins, int tile) const
{
  std::size_t count = 0;
  forBins(this->Grid, bins, tile,
    [&](const Bins& all, const TileGrid::Level& level, int bin)
    {
      count += all.triangles().pageCount(bin);
      count += this->Grid.isFinest(level) ? all.hits().pageCount(bin) : 0;
    });
  return count;
}

void TileTasks::plan(const std::vector<const Bins*>& bins)
{
  this->Tasks.clear();
  this->Splits.clear();
  this->Groups.assign(1, 0);
  this->Batches.assign(1, 0);
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
    batchWeight += weight;
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
void TileTasks::addShares(int tile, std::size_t shares)
{
  const auto split = static_cast<int>(this->Splits.size());
  this->Splits.push_back(std::make_unique<SplitTile>());
  this->Splits.back()->remaining = static_cast<int>(shares);
  this->Splits.back()->tile.reset(this->Frame, this->Part, this->Grid, this->Grid.window(tile));
  for (std::size_t share = 0; share < shares; ++share)
  {
    this->Tasks.push_back({ tile, static_cast<int>(share), static_cast<int>(shares), split });
    this->endGroup();
  }
}

void TileTasks::endGroup()
{
  if (this->Groups.back() != this->Tasks.size())
  {
    this->Groups.push_back(this->Tasks.size());
  }
}

void TileTasks::endBatch()
{
  this->endGroup();
  if (this->Batches.back() != this->Groups.size() - 1)
  {
    this->Batches.push_back(this->Groups.size() - 1);
  }
}

/// The number of tasks for a tile; 0 if it has no pages.
std::size_t TileTasks::sharesFor(std::size_t pages) const
{
  const std::size_t workers = this->Scratch.size();
  return workers > 1 && pages > pagesToSplit
    ? std::min({ pages / (pagesToSplit / 4), 4 * workers, maximumShares })
    : std::min<std::size_t>(pages, 1);
}

void TileTasks::run(std::size_t batch, const std::vector<const Bins*>& bins,
  const Parallel& parallel, bool isLastRound)
{
  if (!isLastRound && this->Kept.empty())
  {
    this->Kept.resize(this->Grid.tileCount());
    for (int tile = 0; tile < this->Grid.tileCount(); ++tile)
    {
      this->Kept[tile].reset(this->Frame, this->Part, this->Grid, this->Grid.window(tile));
    }
  }
  forEach(parallel, this->Batches[batch], this->Batches[batch + 1],
    [&](int worker, std::size_t group)
    {
      std::unique_ptr<Memory>& memory = this->Scratch[worker];
      if (!memory)
      {
        memory.reset(new Memory); // allocated by the worker itself, without zeroing
      }
      for (std::size_t task = this->Groups[group]; task < this->Groups[group + 1]; ++task)
      {
        this->run(this->Tasks[task], bins, *memory, isLastRound);
      }
    });
}

void TileTasks::run(
  const Task& task, const std::vector<const Bins*>& bins, Memory& memory, bool isLastRound)
{
  if (task.shares == 0 && this->Kept.empty())
  {
    this->Painter.paintBackground(this->Grid.window(task.tile));
    return;
  }
  TileHits<Nearest>* tile = &memory.tile;
  tile->reset(this->Frame, this->Part, this->Grid, this->Grid.window(task.tile));
  this->cast(task, bins, memory);
  if (task.split >= 0)
  {
    SplitTile& split = *this->Splits[task.split];
    const std::lock_guard<std::mutex> lock(split.mutex);
    this->Caster.merge(*tile, split.tile);
    if (--split.remaining > 0)
    {
      return;
    }
    tile = &split.tile;
  }
  if (!this->Kept.empty())
  {
    this->Caster.merge(*tile, this->Kept[task.tile]);
    tile = &this->Kept[task.tile];
  }
  if (isLastRound)
  {
    this->paint(*tile, memory);
  }
}

void TileTasks::cast(const Task& task, const std::vector<const Bins*>& bins, Memory& memory) const
{
  int number = 0;
  const auto isMine = [&]() { return number++ % task.shares == task.share; };
  forBins(this->Grid, bins, task.tile,
    [&](const Bins& all, const TileGrid::Level& level, int bin)
    {
      all.triangles().forPages(bin,
        [&](const BinEntry* entries, int count)
        {
          if (isMine())
          {
            this->Kernels ? this->Caster.cast(entries, count, level, memory.tile, memory.triangles)
                          : this->Caster.castPlainly(entries, count, level, memory.tile);
          }
        });
      if (this->Grid.isFinest(level))
      {
        all.hits().forPages(bin,
          [&](const Fragment* hits, int count)
          {
            if (isMine())
            {
              this->Caster.addHits(hits, count, memory.tile);
            }
          });
      }
    });
  if (this->Kernels)
  {
    this->Caster.flush(memory.tile, memory.triangles);
  }
}

void TileTasks::paint(const TileHits<Nearest>& tile, Memory& memory) const
{
  if (this->Kernels)
  {
    this->Painter.paint(tile.samples, tile.hits.triangles(), memory.painting);
  }
  else
  {
    this->Painter.paintPlainly(tile.samples, tile.hits.triangles());
  }
}
}
