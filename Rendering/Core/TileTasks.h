// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief processes the tiles: casts their rays, shades the hits, stores the pixels
 *
 * Each task of TilePlan.h is done in the worker's own memory. The tasks of a split tile merge
 * their hits, and the last of them shades. In a scene that has transparent surfaces, a tile is cast
 * once more for these.
 */
#ifndef lambent_TileTasks_h
#define lambent_TileTasks_h

#include "Casting.h"
#include "LayerPainting.h"
#include "Painting.h"
#include "Parallel.h"
#include "TilePlan.h"

#include <memory>
#include <mutex>
#include <vector>

namespace lambent
{
/// Casts and paints the hits of opaque surfaces, and those of transparent ones.
struct TileSteps
{
  const FrameMesh& mesh;
  const Casting<Nearest>& casting;
  const Casting<Layers>& layerCasting;
  const Painting& painting;
  const LayerPainting& layerPainting;
};

class TileTasks
{
public:
  /// kernels: whether to use them for casting and painting.
  TileTasks(const CameraFrame& frame, const Window& part, const TileGrid& grid,
    const TileSteps& steps, int workers, bool kernels)
    : Frame(frame)
    , Part(part)
    , Grid(grid)
    , Steps(steps)
    , HasTransparency(steps.mesh.mesh().hasTransparency())
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
  /// The hits of a tile. `transparent` is not used if the scene has no transparent surfaces.
  struct AllHits
  {
    TileHits<Nearest> opaque;
    TileHits<Layers> transparent;
  };
  /// Collects the hits of its shares.
  struct SplitTile
  {
    std::mutex mutex;
    AllHits tile;
    int remaining;
  };
  /// A worker's memory for the current tile.
  struct Memory
  {
    AllHits tile;
    CastingMemory casting;
    PaintingMemory painting;
    std::unique_ptr<LayerMemory> layers; ///< if the scene has transparent surfaces
  };

  void run(
    const TileTask& task, const std::vector<const Bins*>& bins, Memory& memory, bool isLastRound);
  bool isHit(const TileTask& task) const
  {
    return task.shares > 0 || (!this->Kept.empty() && this->Kept[task.tile]);
  }
  void reset(AllHits& hits, int tile) const;
  void merge(const AllHits& from, AllHits& hits) const;
  AllHits& keep(const AllHits& hits, int tile);
  void extend(Window& background, const Window& tile) const;
  void paintBackground(const Window& samples) const;
  void cast(const TileTask& task, const std::vector<const Bins*>& bins, Memory& memory) const;
  template <typename Policy>
  void cast(const TileTask& task, const std::vector<const Bins*>& bins,
    const Casting<Policy>& casting, TileHits<Policy>& tile, CastingMemory& memory) const;
  void paint(const AllHits& tile, Memory& memory) const;
  void paintLayers(const AllHits& tile, Memory& memory) const;

  const CameraFrame& Frame;
  const Window Part;
  const TileGrid& Grid;
  const TileSteps Steps;
  const bool HasTransparency;
  const bool Kernels;
  TilePlan Plan;
  std::vector<std::unique_ptr<Memory>> Scratch; ///< one per worker
  /// One per tile that has been hit, if there is more than one round.
  std::vector<std::unique_ptr<AllHits>> Kept;
  std::vector<std::unique_ptr<SplitTile>> Splits;
};
}

#endif
