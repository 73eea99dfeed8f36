// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief each input's share of the progress of work on all inputs
 */
#ifndef InputShares_h
#define InputShares_h

#include "Chunks.h"
#include "Parallel.h"
#include "SceneSettings.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace lambent::adapters
{
/// Inputs with fewer triangles are small: each is processed by one thread, several at a time.
constexpr std::size_t trianglesOfSmall = 32 * 1024;

/// Parallel loops without checkpoints, for work that is too small to need them.
class Unwatched : public Parallel
{
public:
  explicit Unwatched(const Parallel& whole)
    : Whole(whole)
  {
  }
  int workers() const override { return this->Whole.workers(); }
  void run(const std::function<void(int worker)>& body) const override { this->Whole.run(body); }

private:
  const Parallel& Whole;
};

/// Divides the work by the numbers of triangles, lines and points. There may be a hundred thousand
/// inputs, so many small ones share one checkpoint.
class InputShares
{
public:
  InputShares(const std::vector<SceneSettings::Input>& inputs, const Parallel& whole)
    : Whole(whole)
    , Small(whole)
  {
    std::size_t before = 0;
    for (const SceneSettings::Input& input : inputs)
    {
      before += costOfAny + corners(input.mesh->GetPolys()) / 3 + corners(input.mesh->GetStrips()) +
        corners(input.mesh->GetLines()) + corners(input.mesh->GetVerts());
      this->Ends.push_back(before);
    }
  }

  /// The share of the next input; valid until the next call.
  const Parallel& next()
  {
    const std::size_t begin = this->Next == 0 ? 0 : this->Ends[this->Next - 1];
    const std::size_t end = this->Ends[this->Next++];
    const double all = static_cast<double>(this->Ends.back());
    if (end - begin >= trianglesOfSmall)
    {
      this->Large.emplace(this->Whole, begin / all, end / all);
      return *this->Large;
    }
    if (begin - this->AtCheckpoint > mostItemsPerPart || this->SinceCheckpoint.isOver())
    {
      this->Whole.checkpoint(begin / all);
      this->AtCheckpoint = begin;
      this->SinceCheckpoint = PartClock();
    }
    return this->Small;
  }

private:
  static constexpr std::size_t costOfAny = 500; ///< the fixed cost of an input, in triangles

  static std::size_t corners(vtkCellArray* cells)
  {
    return static_cast<std::size_t>(cells->GetNumberOfConnectivityIds());
  }

  const Parallel& Whole;
  const Unwatched Small;
  std::optional<Share> Large;
  std::vector<std::size_t> Ends;
  std::size_t Next = 0;
  std::size_t AtCheckpoint = 0;
  PartClock SinceCheckpoint;
};
}

#endif
