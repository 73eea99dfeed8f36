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
    this->Splits.back()->tile.reset(
      this->Frame, this->Part, this->Grid, this->Grid.window(split.tile));
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

/// Adds hits of this round to those of a tile.
TileHits<Nearest>& TileTasks::keep(const TileHits<Nearest>& hits, int tile)
{
  std::unique_ptr<TileHits<Nearest>>& kept = this->Kept[tile];
  if (kept)
  {
    this->Caster.merge(hits, *kept);
  }
  else
  {
    kept = std::make_unique<TileHits<Nearest>>(hits);
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
    this->Painter.paintBackground(samples);
  }
}

void TileTasks::run(
  const TileTask& task, const std::vector<const Bins*>& bins, Memory& memory, bool isLastRound)
{
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
            this->Kernels ? this->Caster.cast(entries, count, level, memory.tile, memory.casting)
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
    this->Caster.flush(memory.tile, memory.casting);
  }
}

void TileTasks::paint(const TileHits<Nearest>& tile, Memory& memory) const
{
  const std::uint32_t* const primitives = tile.hits.primitives();
  this->Kernels ? this->Painter.paint(tile.samples, primitives, memory.painting)
                : this->Painter.paintPlainly(tile.samples, primitives);
}
}
