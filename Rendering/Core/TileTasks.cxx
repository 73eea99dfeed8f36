// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TileTasks.h"

namespace lambent
{
void TileTasks::plan(const std::vector<const Bins*>& bins)
{
  this->Plan.make(bins);
  this->Splits.clear();
  for (const TilePlan::SplitTile& split : this->Plan.splits())
  {
    this->Splits.push_back(std::make_unique<SplitTile>());
    this->Splits.back()->remaining = split.shares;
    this->reset(this->Splits.back()->tile, split.tile);
  }
}

void TileTasks::run(std::size_t batch, const std::vector<const Bins*>& bins,
  const Parallel& parallel, bool isLastRound)
{
  if (!isLastRound && this->Kept.empty())
  {
    this->Kept.resize(this->Grid.tileCount());
  }
  const TilePlan::Range groups = this->Plan.groupsOf(batch);
  forEach(parallel, groups.begin, groups.end,
    [&](int worker, std::size_t group)
    {
      std::unique_ptr<Memory>& memory = this->Scratch[worker];
      if (!memory)
      {
        memory.reset(new Memory); // allocated by the worker itself, without zeroing
      }
      const TilePlan::Range tasks = this->Plan.tasksOf(group);
      Window background; // neighbouring tiles without a hit
      for (std::size_t number = tasks.begin; number < tasks.end; ++number)
      {
        const TileTask& task = this->Plan.task(number);
        if (this->isHit(task))
        {
          this->run(task, bins, *memory, isLastRound);
        }
        else if (isLastRound)
        {
          this->extend(background, this->Grid.window(task.tile));
        }
      }
      this->paintBackground(background);
    });
}

/// Removes all hits.
void TileTasks::reset(AllHits& hits, int tile) const
{
  const Window window = this->Grid.window(tile);
  hits.opaque.reset(this->Frame, this->Part, this->Grid, window);
  if (this->HasTransparency)
  {
    hits.transparent.reset(this->Frame, this->Part, this->Grid, window);
  }
}

void TileTasks::merge(const AllHits& from, AllHits& hits) const
{
  this->Steps.casting.merge(from.opaque, hits.opaque);
  this->Steps.layerCasting.merge(from.transparent, hits.transparent);
}

/// Adds hits of this round to those of a tile.
TileTasks::AllHits& TileTasks::keep(const AllHits& hits, int tile)
{
  std::unique_ptr<AllHits>& kept = this->Kept[tile];
  if (kept)
  {
    this->merge(hits, *kept);
  }
  else
  {
    kept = std::make_unique<AllHits>(hits);
  }
  return *kept;
}

/// Adds a tile to a window of background. If they are not neighbours in a row, the window is
/// painted first and begins anew.
void TileTasks::extend(Window& background, const Window& tile) const
{
  if (tile.i0 == background.i1 && tile.j0 == background.j0 && tile.j1 == background.j1)
  {
    background.i1 = tile.i1;
    return;
  }
  this->paintBackground(background);
  background = tile;
}

void TileTasks::paintBackground(const Window& samples) const
{
  if (!samples.empty())
  {
    this->Steps.painting.paintBackground(samples);
  }
}

void TileTasks::run(
  const TileTask& task, const std::vector<const Bins*>& bins, Memory& memory, bool isLastRound)
{
  AllHits* tile = &memory.tile;
  this->reset(*tile, task.tile);
  this->cast(task, bins, memory);
  if (task.split >= 0)
  {
    SplitTile& split = *this->Splits[task.split];
    const std::lock_guard<std::mutex> lock(split.mutex);
    this->merge(*tile, split.tile);
    if (--split.remaining > 0)
    {
      return;
    }
    tile = &split.tile;
  }
  if (!this->Kept.empty())
  {
    tile = &this->keep(*tile, task.tile);
  }
  if (isLastRound)
  {
    this->paint(*tile, memory);
  }
}

void TileTasks::cast(
  const TileTask& task, const std::vector<const Bins*>& bins, Memory& memory) const
{
  AllHits& tile = memory.tile;
  this->cast(task, bins, this->Steps.casting, tile.opaque, memory.casting);
  if (this->HasTransparency)
  {
    tile.transparent.hits.setOpaque(tile.opaque.hits);
    tile.transparent.least = tile.opaque.least;
    this->cast(task, bins, this->Steps.layerCasting, tile.transparent, memory.casting);
  }
}

template <typename Policy>
void TileTasks::cast(const TileTask& task, const std::vector<const Bins*>& bins,
  const Casting<Policy>& casting, TileHits<Policy>& tile, CastingMemory& memory) const
{
  int number = 0;
  const auto isMine = [&]() { return number++ % task.shares == task.share; };
  forBins(this->Grid, bins, task.tile,
    [&](const Bins& all, const TileGrid::Level& level, int bin)
    {
      all.primitives().forPages(bin,
        [&](const BinEntry* entries, int count)
        {
          if (isMine())
          {
            this->Kernels ? casting.cast(entries, count, level, tile, memory)
                          : casting.castPlainly(entries, count, level, tile);
          }
        });
      if (this->Grid.isFinest(level))
      {
        all.hits().forPages(bin,
          [&](const Fragment* hits, int count)
          {
            if (isMine())
            {
              casting.addHits(hits, count, tile);
            }
          });
      }
    });
  if (this->Kernels)
  {
    casting.flush(tile, memory);
  }
}

void TileTasks::paint(const AllHits& tile, Memory& memory) const
{
  if (this->HasTransparency)
  {
    this->paintLayers(tile, memory);
    return;
  }
  const TileSamples& samples = tile.opaque.samples;
  const std::uint32_t* const primitives = tile.opaque.hits.primitives();
  this->Kernels ? this->Steps.painting.paint(samples, primitives, memory.painting)
                : this->Steps.painting.paintPlainly(samples, primitives);
}

void TileTasks::paintLayers(const AllHits& tile, Memory& memory) const
{
  if (!memory.layers)
  {
    memory.layers = std::make_unique<LayerMemory>();
  }
  const TileSamples& samples = tile.opaque.samples;
  memory.layers->sorted.sort(this->Steps.mesh, tile.opaque, tile.transparent.hits);
  this->Kernels ? this->Steps.layerPainting.paint(samples, *memory.layers)
                : this->Steps.layerPainting.paintPlainly(samples, *memory.layers);
}
}
