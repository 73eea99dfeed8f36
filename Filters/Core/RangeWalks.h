// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief work on ranges of points, each in passes through the faces that touch it
 *
 * The points are divided into ranges of consecutive ids. A worker takes one range after
 * the other and walks the blocks of faces in ascending order, as often as its task needs,
 * so that whatever is summed up for a point sees the faces in the order of a serial loop.
 * Nothing is shared between ranges, so nothing is locked.
 *
 * The price is that a face with corners in two ranges is visited for both; meshes name
 * neighbouring points in neighbouring faces, so few are.
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
/// The points begin to end - 1, and which of the ranges they are.
struct PointRange
{
  std::size_t index = 0;
  std::int64_t begin = 0, end = 0;
};

/// A mesh's points in `ranges` ranges of about the same size.
class PointRanges
{
public:
  /**
   * Several ranges for each worker even out the work and keep its memory in the cache, but
   * a block is walked once for each range that it touches: where blocks name points from
   * everywhere, one range for each worker is least.
   */
  PointRanges(const std::vector<CellBlock>& blocks, std::size_t pointCount, int workers)
    : Points(pointCount)
    , Count(4 * static_cast<std::size_t>(workers))
  {
    constexpr double mostVisitsPerBlock = 1.6;
    while (this->Count > static_cast<std::size_t>(workers) &&
      this->visitsPerBlock(blocks) > mostVisitsPerBlock)
    {
      this->Count /= 2;
    }
  }

  std::size_t count() const { return this->Count; }
  PointRange operator[](std::size_t i) const
  {
    return { i, static_cast<std::int64_t>(this->Points * i / this->Count),
      static_cast<std::int64_t>(this->Points * (i + 1) / this->Count) };
  }

private:
  /// How often a block is walked on average.
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
 *     std::size_t stepCount(int pass) const              asked when the pass begins
 *     std::size_t step(int pass, std::size_t i)          how many faces or points it took
 *
 * Each worker stops now and then, wherever it is on its way, so that there can be a
 * checkpoint.
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
  /// In a cache line of its own, since it is written to all the time.
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
    std::size_t items = 0;
    while (items < itemsPerPart && (walk.hasRange || this->takeRange(walk)))
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
  std::vector<Walk> Walks; ///< one a worker
  std::atomic<std::size_t> NextRange{ 0 };
  std::atomic<std::size_t> FinishedRanges{ 0 };
};
}

#endif
