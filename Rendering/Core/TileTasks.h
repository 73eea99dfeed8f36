// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief processes the tiles: casts their rays, shades the hits, stores the pixels
 *
 * A tile with few triangles is one task, done in the worker's own memory. A worker takes several
 * neighbouring tiles at a time. A tile with many triangles is split into several tasks, each with a
 * share of its triangles. They merge their hits, and the last of them shades. So a mesh that falls
 * into a single tile keeps all workers busy.
 */
#ifndef lambent_TileTasks_h
#define lambent_TileTasks_h

#include "Casting.h"
#include "Painting.h"
#include "Parallel.h"

#include <mutex>

namespace lambent
{
class TileTasks
{
public:
  /// kernels: whether to use them for casting and painting.
  TileTasks(const CameraFrame& frame, const Window& part, const TileGrid& grid,
    const Casting<Nearest>& casting, const Painting& painting, int workers, bool kernels)
    : Frame(frame)
    , Part(part)
    , Grid(grid)
    , Caster(casting)
    , Painter(painting)
    , Kernels(kernels)
    , Scratch(workers)
  {
  }

  /// Divides the tiles into tasks, given the current contents of the bins.
  void plan(const std::vector<const Bins*>& bins);

  /// The number of batches in the plan, each of about the same amount of work.
  std::size_t batchCount() const { return this->Batches.size() - 1; }

  /// Casts one batch. Tiles are painted in the last round. Before that they keep their hits for the
  /// next round.
  void run(std::size_t batch, const std::vector<const Bins*>& bins, const Parallel& parallel,
    bool isLastRound);

private:
  struct Task
  {
    int tile;
    int share, shares; ///< of the tile's pages; shares is 0 if it has no pages
    int split;         ///< index of the split tile that collects the hits, or -1
  };
  struct SplitTile
  {
    std::mutex mutex;
    TileHits<Nearest> tile;
    int remaining;
  };
  /// A worker's memory for the current tile.
  struct Memory
  {
    TileHits<Nearest> tile;
    CastBatch triangles;
    PaintingMemory painting;
  };

  std::size_t countPages(const std::vector<const Bins*>& bins, int tile) const;
  std::size_t sharesFor(std::size_t pages) const;
  void addShares(int tile, std::size_t shares);
  void endGroup();
  void endBatch();
  void run(
    const Task& task, const std::vector<const Bins*>& bins, Memory& memory, bool isLastRound);
  void cast(const Task& task, const std::vector<const Bins*>& bins, Memory& memory) const;
  void paint(const TileHits<Nearest>& tile, Memory& memory) const;

  const CameraFrame& Frame;
  const Window Part;
  const TileGrid& Grid;
  const Casting<Nearest>& Caster;
  const Painting& Painter;
  const bool Kernels;
  std::vector<std::unique_ptr<Memory>> Scratch; ///< one per worker
  std::vector<TileHits<Nearest>> Kept;          ///< one per tile, if there is more than one round
  std::vector<Task> Tasks;
  std::vector<std::size_t> Groups;  ///< of tasks for one worker: the first of each, and the end
  std::vector<std::size_t> Batches; ///< of groups: the first of each, and the end
  std::vector<std::unique_ptr<SplitTile>> Splits;
};
}

#endif
