// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief loops over chunks of a range, with checkpoints between parts
 *
 * A part takes some ten milliseconds, so that progress and aborts are handled promptly.
 */
#ifndef lambent_Chunks_h
#define lambent_Chunks_h

#include "Parallel.h"

#include <algorithm>
#include <cstddef>

namespace lambent
{
/// The number of points or faces that are processed between two checkpoints.
constexpr std::size_t itemsPerPart = 512 * 1024;

inline std::size_t chunkCount(std::size_t count, std::size_t chunkSize)
{
  return (count + chunkSize - 1) / chunkSize;
}

/// A share of some work: maps its progress, from 0 to 1, to [begin, end] of the whole.
class Share : public Parallel
{
public:
  Share(const Parallel& whole, double begin, double end)
    : Whole(whole)
    , Begin(begin)
    , End(end)
  {
  }

  int workers() const override { return this->Whole.workers(); }
  void run(const std::function<void(int worker)>& body) const override { this->Whole.run(body); }
  void checkpoint(double done) const override
  {
    this->Whole.checkpoint(this->Begin + done * (this->End - this->Begin));
  }

private:
  const Parallel& Whole;
  const double Begin, End;
};

/// Calls body(begin, end) for each part of [0, count), in order. Choose a smaller partSize if an
/// item takes longer than usual.
template <std::size_t partSize = itemsPerPart, typename Body>
void forEachPart(const Parallel& parallel, std::size_t count, Body&& body)
{
  for (std::size_t begin = 0; begin < count; begin += partSize)
  {
    const std::size_t end = std::min(count, begin + partSize);
    body(begin, end);
    parallel.checkpoint(static_cast<double>(end) / static_cast<double>(count));
  }
}

/// Calls body(begin, end) for [0, chunkSize), [chunkSize, 2 chunkSize) and so on up to count, in
/// any order. A part consists of whole chunks.
template <std::size_t chunkSize, std::size_t partSize = itemsPerPart, typename Body>
void forEachChunk(const Parallel& parallel, std::size_t count, Body&& body)
{
  static_assert(partSize % chunkSize == 0);
  forEachPart<partSize>(parallel, count,
    [&](std::size_t partBegin, std::size_t partEnd)
    {
      forEach(parallel, partBegin / chunkSize, chunkCount(partEnd, chunkSize),
        [&](int, std::size_t chunk)
        {
          const std::size_t begin = chunk * chunkSize;
          body(begin, std::min(count, begin + chunkSize));
        });
    });
}
}

#endif
