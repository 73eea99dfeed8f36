// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief process ranges of points, each in passes over the faces that touch it
 *
 * The points are divided into ranges of consecutive ids. A worker takes one range after
 * another and walks the blocks of faces in ascending order, once for each pass of its task.
 * So a sum over the faces of a point adds them in the order of a serial loop. Nothing is shared
 * between ranges, so nothing is locked.
 *
 * The price is that a face with corners in two ranges is visited for both. Neighbouring faces
 * usually have neighbouring point ids, so there are few such faces.
 */
#ifndef lambent_RangeWalks_h
#define lambent_RangeWalks_h

#include "CellBlocks.h"
#include "Chunks.h"
#include "Parallel.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent
{
/// The points begin to end - 1, and the index of this range.
struct PointRange
{
  std::size_t index = 0;
  std::int64_t begin = 0, end = 0;
};

/// Divides a mesh's points into ranges of about the same size.
class PointRanges
{
public:
  /**
   * Several ranges per worker balance the load. Small ranges keep a worker's memory in the cache
   * and its steps short. But each block is walked once for each range that it touches. If blocks
   * have points from all over the mesh, a single range per worker is best.
   */
  PointRanges(const std::vector<CellBlock>& blocks, std::size_t pointCount, int workers)
    : Points(pointCount)
    , Count(std::max(4 * static_cast<std::size_t>(workers), pointCount / pointsPerRange))
  {
    constexpr double mostVisitsPerBlock = 1.6;
    const auto fewest = static_cast<std::size_t>(workers);
    while (this->Count > fewest && this->visitsPerBlock(blocks) > mostVisitsPerBlock)
    {
      this->Count = std::max(this->Count / 2, fewest);
    }
  }

  std::size_t count() const { return this->Count; }
  PointRange operator[](std::size_t i) const
  {
    return { i, static_cast<std::int64_t>(this->Points * i / this->Count),
      static_cast<std::int64_t>(this->Points * (i + 1) / this->Count) };
  }

private:
  static constexpr std::size_t pointsPerRange = 64 * 1024;

  /// How many times a block is walked, on average.
  double visitsPerBlock(const std::vector<CellBlock>& blocks) const
  {
    std::ptrdiff_t visits = 0;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const PointRange range = (*this)[i];
      visits += std::count_if(blocks.begin(), blocks.end(),
        [&](const CellBlock& block) { return block.touches(range.begin, range.end); });
    }
    return static_cast<double>(visits) /
      static_cast<double>(std::max<std::size_t>(blocks.size(), 1));
  }

  std::size_t Points;
  std::size_t Count;
};

/**
 * Runs a Task for each range. A Task is copied once for each worker and has
 *
 *     void reset(const PointRange&)                      before the first pass
 *     int passCount() const
 *     std::size_t stepCount(int pass) const              called when the pass begins
 *     std::size_t step(int pass, std::size_t i)          returns the faces or points processed
 *
 * From time to time all workers pause, in the middle of their walks, for a checkpoint.
 */
template <typename Task>
class RangeWalks
{
public:
  RangeWalks(const PointRanges& ranges, const Task& task, const Parallel& parallel)
    : Ranges(ranges)
    , Workers(parallel)
    , Walks(static_cast<std::size_t>(parallel.workers()), Walk{ task })
  {
  }

  void run()
  {
    while (this->FinishedRanges < this->Ranges.count())
    {
      forEach(this->Workers, 0, this->Walks.size(),
        [this](int, std::size_t i) { this->goOn(this->Walks[i]); });
      this->Workers.checkpoint(this->done());
    }
  }

private:
  /// Has its own cache line, since it is written constantly.
  struct alignas(64) Walk
  {
    Task task;
    bool hasRange = false;
    int pass = 0;
    std::size_t step = 0;
    std::size_t stepCount = 0;
  };

  void goOn(Walk& walk)
  {
    const PartClock clock;
    std::size_t items = 0;
    while (items < mostItemsPerPart && !clock.isOver() && (walk.hasRange || this->takeRange(walk)))
    {
      if (walk.step < walk.stepCount)
      {
        items += walk.task.step(walk.pass, walk.step++);
      }
      else
      {
        this->finishPass(walk);
      }
    }
  }

  bool takeRange(Walk& walk)
  {
    const std::size_t range = this->NextRange++;
    walk.hasRange = range < this->Ranges.count();
    if (walk.hasRange)
    {
      walk.task.reset(this->Ranges[range]);
      walk.pass = 0;
      walk.step = 0;
      walk.stepCount = walk.task.stepCount(0);
    }
    return walk.hasRange;
  }

  void finishPass(Walk& walk)
  {
    ++walk.pass;
    walk.step = 0;
    walk.hasRange = walk.pass < walk.task.passCount();
    if (walk.hasRange)
    {
      walk.stepCount = walk.task.stepCount(walk.pass);
    }
    else
    {
      ++this->FinishedRanges;
    }
  }

  double done() const
  {
    double ranges = static_cast<double>(this->FinishedRanges);
    for (const Walk& walk : this->Walks)
    {
      const double pass =
        walk.pass + static_cast<double>(walk.step) / static_cast<double>(walk.stepCount + 1);
      ranges += walk.hasRange ? pass / walk.task.passCount() : 0.0;
    }
    return ranges / static_cast<double>(this->Ranges.count());
  }

  const PointRanges& Ranges;
  const Parallel& Workers;
  std::vector<Walk> Walks; ///< one per worker
  std::atomic<std::size_t> NextRange{ 0 };
  std::atomic<std::size_t> FinishedRanges{ 0 };
};
}

#endif
