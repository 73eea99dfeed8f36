// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief how the work on the tiles is divided among the workers
 *
 * A tile with few primitives is one task. A tile with many is split into several tasks, each with a
 * share of its primitives, so that a mesh that falls into a single tile keeps all workers busy. A
 * group of tasks goes to one worker, a batch of groups lies between two looks at the progress.
 */
#ifndef lambent_TilePlan_h
#define lambent_TilePlan_h

#include "Bins.h"

#include <cstddef>
#include <vector>

namespace lambent
{
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

struct TileTask
{
  int tile;
  int share, shares; ///< of the tile's pages; shares is 0 if it has no pages
  int split;         ///< index among the split tiles, or -1
};

class TilePlan
{
public:
  struct SplitTile
  {
    int tile, shares;
  };
  /// Indices from begin to end - 1.
  struct Range
  {
    std::size_t begin, end;
  };

  TilePlan(const TileGrid& grid, int workers)
    : Grid(grid)
    , Workers(static_cast<std::size_t>(workers))
  {
  }

  /// Divides the tiles into tasks, given the current contents of the bins.
  void make(const std::vector<const Bins*>& bins);

  /// Each batch is about the same amount of work.
  std::size_t batchCount() const { return this->Batches.size() - 1; }
  Range groupsOf(std::size_t batch) const
  {
    return { this->Batches[batch], this->Batches[batch + 1] };
  }
  Range tasksOf(std::size_t group) const
  {
    return { this->Groups[group], this->Groups[group + 1] };
  }
  const TileTask& task(std::size_t number) const { return this->Tasks[number]; }
  const std::vector<SplitTile>& splits() const { return this->Splits; }

private:
  std::size_t countPages(const std::vector<const Bins*>& bins, int tile) const;
  std::size_t sharesFor(std::size_t pages) const;
  void addShares(int tile, std::size_t shares);
  void endGroup();
  void endBatch();

  const TileGrid& Grid;
  const std::size_t Workers;
  std::vector<TileTask> Tasks;
  std::vector<std::size_t> Groups;  ///< of tasks: the first of each, and the end
  std::vector<std::size_t> Batches; ///< of groups: the first of each, and the end
  std::vector<SplitTile> Splits;
};
}

#endif
