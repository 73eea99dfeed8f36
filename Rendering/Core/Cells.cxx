// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Cells.h"

namespace lambent
{
namespace
{
// From how many pages on a cell is split, and into how many tasks at the most.
constexpr std::size_t pagesToSplit = 128;
constexpr std::size_t maximumShares = 32;

// Neighbours are handed out together: their pixels share cache lines, which two workers
// would keep taking from each other.
constexpr std::size_t mostCellsInGroup = 16;
constexpr std::size_t mostWeightInGroup = 128;

// Of a batch, in pages; an empty cell counts as much as a few. A batch takes some
// milliseconds, so that progress is told and an abort heard in time.
constexpr std::size_t mostWeightInBatch = 8 * 1024;
constexpr std::size_t emptyCellWeight = 2;

/// Calls body(bins, level, bin) for the bins of a cell and of those above it.
template <typename Body>
void forBins(const CellGrid& grid, const std::vector<const Bins*>& bins, int cell, Body&& body)
{
  const Window rays = grid.window(cell);
  for (const CellGrid::Level& level : grid.levels())
  {
    for (const Bins* workerBins : bins)
    {
      body(*workerBins, level, level.cellAt(rays.i0, rays.j0));
    }
  }
}
}

std::size_t Cells::countPages(const std::vector<const Bins*>& bins, int cell) const
{
  std::size_t count = 0;
  forBins(this->Grid, bins, cell,
    [&](const Bins& all, const CellGrid::Level& level, int bin)
    {
      count += all.triangles().pageCount(bin);
      count += this->Grid.isFinest(level) ? all.hits().pageCount(bin) : 0;
    });
  return count;
}

void Cells::plan(const std::vector<const Bins*>& bins)
{
  this->Tasks.clear();
  this->Splits.clear();
  this->Groups.assign(1, 0);
  this->Batches.assign(1, 0);
  std::size_t groupWeight = 0, groupCells = 0, batchWeight = 0;
  for (int cell = 0; cell < this->Grid.cellCount(); ++cell)
  {
    const std::size_t pages = this->countPages(bins, cell);
    const std::size_t shares = this->sharesFor(pages);
    const std::size_t weight = pages + emptyCellWeight;
    if (shares > 1 || groupCells == mostCellsInGroup || groupWeight > mostWeightInGroup)
    {
      this->endGroup();
      groupWeight = groupCells = 0;
    }
    if (batchWeight > mostWeightInBatch)
    {
      this->endBatch();
      groupWeight = groupCells = batchWeight = 0;
    }
    groupWeight += weight;
    batchWeight += weight;
    ++groupCells;
    if (shares > 1)
    {
      this->addShares(cell, shares);
    }
    else
    {
      this->Tasks.push_back({ cell, 0, static_cast<int>(shares), -1 });
    }
  }
  this->endBatch();
}

/// Each share of a split cell is a group of its own.
void Cells::addShares(int cell, std::size_t shares)
{
  const auto split = static_cast<int>(this->Splits.size());
  this->Splits.push_back(std::make_unique<SplitCell>());
  this->Splits.back()->remaining = static_cast<int>(shares);
  this->Splits.back()->rays.reset(this->Frame, this->Image, this->Grid, this->Grid.window(cell));
  for (std::size_t share = 0; share < shares; ++share)
  {
    this->Tasks.push_back({ cell, static_cast<int>(share), static_cast<int>(shares), split });
    this->endGroup();
  }
}

void Cells::endGroup()
{
  if (this->Groups.back() != this->Tasks.size())
  {
    this->Groups.push_back(this->Tasks.size());
  }
}

void Cells::endBatch()
{
  this->endGroup();
  if (this->Batches.back() != this->Groups.size() - 1)
  {
    this->Batches.push_back(this->Groups.size() - 1);
  }
}

/// Into how many tasks a cell is split; 0 if it has nothing to do.
std::size_t Cells::sharesFor(std::size_t pages) const
{
  const std::size_t workers = this->Scratch.size();
  return workers > 1 && pages > pagesToSplit
    ? std::min({ pages / (pagesToSplit / 4), 4 * workers, maximumShares })
    : std::min<std::size_t>(pages, 1);
}

void Cells::run(std::size_t batch, const std::vector<const Bins*>& bins, const Parallel& parallel,
  bool isLastRound)
{
  if (!isLastRound && this->Kept.empty())
  {
    this->Kept.resize(this->Grid.cellCount());
    for (int cell = 0; cell < this->Grid.cellCount(); ++cell)
    {
      this->Kept[cell].reset(this->Frame, this->Image, this->Grid, this->Grid.window(cell));
    }
  }
  forEach(parallel, this->Batches[batch], this->Batches[batch + 1],
    [&](int worker, std::size_t group)
    {
      std::unique_ptr<Memory>& memory = this->Scratch[worker];
      if (!memory)
      {
        memory.reset(new Memory); // by the worker itself, and not written over
      }
      for (std::size_t task = this->Groups[group]; task < this->Groups[group + 1]; ++task)
      {
        this->run(this->Tasks[task], bins, *memory, isLastRound);
      }
    });
}

void Cells::run(
  const Task& task, const std::vector<const Bins*>& bins, Memory& memory, bool isLastRound)
{
  if (task.shares == 0 && this->Kept.empty())
  {
    this->Painter.paintBackground(this->Grid.window(task.cell));
    return;
  }
  CellRays* rays = &memory.rays;
  rays->reset(this->Frame, this->Image, this->Grid, this->Grid.window(task.cell));
  this->cast(task, bins, memory);
  if (task.split >= 0)
  {
    SplitCell& split = *this->Splits[task.split];
    const std::lock_guard<std::mutex> lock(split.mutex);
    this->Caster.merge(*rays, split.rays);
    if (--split.remaining > 0)
    {
      return;
    }
    rays = &split.rays;
  }
  if (!this->Kept.empty())
  {
    this->Caster.merge(*rays, this->Kept[task.cell]);
    rays = &this->Kept[task.cell];
  }
  if (isLastRound)
  {
    this->paint(*rays, memory);
  }
}

void Cells::cast(const Task& task, const std::vector<const Bins*>& bins, Memory& memory) const
{
  int number = 0;
  const auto isMine = [&]() { return number++ % task.shares == task.share; };
  forBins(this->Grid, bins, task.cell,
    [&](const Bins& all, const CellGrid::Level& level, int bin)
    {
      all.triangles().forPages(bin,
        [&](const BinEntry* entries, int count)
        {
          if (isMine())
          {
            this->Kernels ? this->Caster.cast(entries, count, level, memory.rays, memory.triangles)
                          : this->Caster.castPlainly(entries, count, level, memory.rays);
          }
        });
      if (this->Grid.isFinest(level))
      {
        all.hits().forPages(bin,
          [&](const Fragment* hits, int count)
          {
            if (isMine())
            {
              this->Caster.addHits(hits, count, memory.rays);
            }
          });
      }
    });
  if (this->Kernels)
  {
    this->Caster.flush(memory.rays, memory.triangles);
  }
}

void Cells::paint(const CellRays& rays, Memory& memory) const
{
  if (this->Kernels)
  {
    this->Painter.paint(rays, memory.pieces);
  }
  else
  {
    this->Painter.paintPlainly(rays);
  }
}
}
