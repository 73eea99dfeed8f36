// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief loops over chunks of a range, with checkpoints between parts
 *
 * A part takes about ten milliseconds (Pace.h), so that progress and aborts are handled promptly.
 */
#ifndef lambent_Chunks_h
#define lambent_Chunks_h

#include "Pace.h"
#include "Parallel.h"

#include <algorithm>
#include <cstddef>

namespace lambent
{
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

/// Calls body(begin, end) for each part of [0, count), in order. A part is a multiple of chunkSize.
template <std::size_t chunkSize = 1, typename Body>
void forEachPart(const Parallel& parallel, std::size_t count, Body&& body)
{
  Pace pace;
  for (std::size_t begin = 0; begin < count;)
  {
    const PartClock clock;
    const std::size_t end =
      std::min(count, begin + chunkCount(pace.items(), chunkSize) * chunkSize);
    body(begin, end);
    pace.adjust(clock.elapsed());
    parallel.checkpoint(static_cast<double>(end) / static_cast<double>(count));
    begin = end;
  }
}

/// Calls body(begin, end) for [0, chunkSize), [chunkSize, 2 chunkSize) and so on up to count, in
/// any order.
template <std::size_t chunkSize, typename Body>
void forEachChunk(const Parallel& parallel, std::size_t count, Body&& body)
{
  forEachPart<chunkSize>(parallel, count,
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
