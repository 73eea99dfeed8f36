// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief process the cells: cast their rays, shade the hits, write the pixels
 *
 * A cell with few triangles is one task, done in memory of the worker's own, and a
 * worker takes several neighbours at a time. One with many is split into several tasks,
 * each with a share of its triangles; they merge what they hit, and the last of them
 * shades. So a mesh that falls into a single cell keeps all workers busy.
 */
#ifndef lambent_Cells_h
#define lambent_Cells_h

#include "Casting.h"
#include "Painting.h"
#include "Parallel.h"

#include <mutex>

namespace lambent
{
class Cells
{
public:
  /// kernels: whether to cast and paint with them, or plainly.
  Cells(const CameraFrame& frame, const Window& image, const CellGrid& grid, const Casting& casting,
    const Painting& painting, int workers, bool kernels)
    : Frame(frame)
    , Image(image)
    , Grid(grid)
    , Caster(casting)
    , Painter(painting)
    , Kernels(kernels)
    , Scratch(workers)
  {
  }

  /// Share out the cells with the triangles that are in the bins now.
  void plan(const std::vector<const Bins*>& bins);

  /// The number of batches that the plan has, each about equally much work.
  std::size_t batchCount() const { return this->Batches.size() - 1; }

  /// Cast one batch. Cells are painted in the last round, before that they keep
  /// their hits for the next one.
  void run(std::size_t batch, const std::vector<const Bins*>& bins, const Parallel& parallel,
    bool isLastRound);

private:
  struct Task
  {
    int cell;
    int share, shares; ///< of the cell's pages; none if it has no pages
    int split;         ///< index of the split cell that the hits go to, or -1
  };
  struct SplitCell
  {
    std::mutex mutex;
    CellRays rays;
    int remaining;
  };
  /// What a worker needs for the cell at hand.
  struct Memory
  {
    CellRays rays;
    CastBatch triangles;
    ShadeBatch pieces;
  };

  std::size_t countPages(const std::vector<const Bins*>& bins, int cell) const;
  std::size_t sharesFor(std::size_t pages) const;
  void addShares(int cell, std::size_t shares);
  void endGroup();
  void endBatch();
  void run(
    const Task& task, const std::vector<const Bins*>& bins, Memory& memory, bool isLastRound);
  void cast(const Task& task, const std::vector<const Bins*>& bins, Memory& memory) const;
  void paint(const CellRays& rays, Memory& memory) const;

  const CameraFrame& Frame;
  const Window Image;
  const CellGrid& Grid;
  const Casting& Caster;
  const Painting& Painter;
  const bool Kernels;
  std::vector<std::unique_ptr<Memory>> Scratch; ///< one a worker
  std::vector<CellRays> Kept;                   ///< one a cell, once there is a second round
  std::vector<Task> Tasks;
  std::vector<std::size_t> Groups;  ///< of tasks for one worker: first of each, and the end
  std::vector<std::size_t> Batches; ///< of groups: first of each, and the end
  std::vector<std::unique_ptr<SplitCell>> Splits;
};
}

#endif
