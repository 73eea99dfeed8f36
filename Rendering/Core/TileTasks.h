// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief processes the tiles: casts their rays, shades the hits, stores the pixels
 *
 * Each task of TilePlan.h is done in the worker's own memory. The tasks of a split tile merge
 * their hits, and the last of them shades.
 */
#ifndef lambent_TileTasks_h
#define lambent_TileTasks_h

#include "Casting.h"
#include "Painting.h"
#include "Parallel.h"
#include "TilePlan.h"

#include <memory>
#include <mutex>
#include <vector>

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
    , Plan(grid, workers)
    , Scratch(workers)
  {
  }

  /// Divides the tiles into tasks, given the current contents of the bins.
  void plan(const std::vector<const Bins*>& bins);

  /// The number of batches in the plan, each of about the same amount of work.
  std::size_t batchCount() const { return this->Plan.batchCount(); }

  /// Casts one batch. Tiles are painted in the last round. Before that they keep their hits for the
  /// next round.
  void run(std::size_t batch, const std::vector<const Bins*>& bins, const Parallel& parallel,
    bool isLastRound);

private:
  /// Collects the hits of its shares.
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
    CastingMemory casting;
    PaintingMemory painting;
  };

  void run(
    const TileTask& task, const std::vector<const Bins*>& bins, Memory& memory, bool isLastRound);
  bool isHit(const TileTask& task) const
  {
    return task.shares > 0 || (!this->Kept.empty() && this->Kept[task.tile]);
  }
  TileHits<Nearest>& keep(const TileHits<Nearest>& hits, int tile);
  void extend(Window& background, const Window& tile) const;
  void paintBackground(const Window& samples) const;
  void cast(const TileTask& task, const std::vector<const Bins*>& bins, Memory& memory) const;
  void paint(const TileHits<Nearest>& tile, Memory& memory) const;

  const CameraFrame& Frame;
  const Window Part;
  const TileGrid& Grid;
  const Casting<Nearest>& Caster;
  const Painting& Painter;
  const bool Kernels;
  TilePlan Plan;
  std::vector<std::unique_ptr<Memory>> Scratch; ///< one per worker
  /// One per tile that has been hit, if there is more than one round.
  std::vector<std::unique_ptr<TileHits<Nearest>>> Kept;
  std::vector<std::unique_ptr<SplitTile>> Splits;
};
}

#endif
