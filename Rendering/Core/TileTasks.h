// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief process the tiles: cast their rays, shade the hits, write the pixels
 *
 * A tile with few triangles is one task, done in memory of the worker's own, and a
 * worker takes several neighbours at a time. One with many is split into several tasks,
 * each with a share of its triangles; they merge what they hit, and the last of them
 * shades. So a mesh that falls into a single tile keeps all workers busy.
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
  /// kernels: whether to cast and paint with them, or plainly.
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

  /// Share out the tiles with the triangles that are in the bins now.
  void plan(const std::vector<const Bins*>& bins);

  /// The number of batches that the plan has, each about equally much work.
  std::size_t batchCount() const { return this->Batches.size() - 1; }

  /// Cast one batch. TileTasks are painted in the last round, before that they keep
  /// their hits for the next one.
  void run(std::size_t batch, const std::vector<const Bins*>& bins, const Parallel& parallel,
    bool isLastRound);

private:
  struct Task
  {
    int tile;
    int share, shares; ///< of the tile's pages; none if it has no pages
    int split;         ///< index of the split tile that the hits go to, or -1
  };
  struct SplitTile
  {
    std::mutex mutex;
    TileHits<Nearest> tile;
    int remaining;
  };
  /// What a worker needs for the tile at hand.
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
  std::vector<std::unique_ptr<Memory>> Scratch; ///< one a worker
  std::vector<TileHits<Nearest>> Kept;          ///< one a tile, once there is a second round
  std::vector<Task> Tasks;
  std::vector<std::size_t> Groups;  ///< of tasks for one worker: first of each, and the end
  std::vector<std::size_t> Batches; ///< of groups: first of each, and the end
  std::vector<std::unique_ptr<SplitTile>> Splits;
};
}

#endif
