// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief when the next checkpoint is due
 *
 * Progress and aborts should be handled promptly, however much work the items of a loop are. The
 * clock only decides where work is interrupted. No result depends on that.
 */
#ifndef lambent_Pace_h
#define lambent_Pace_h

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace lambent
{
/// The largest number of points or faces that are processed between two checkpoints.
constexpr std::size_t mostItemsPerPart = 512 * 1024;

/// The time between two checkpoints, about.
constexpr std::chrono::milliseconds partTime{ 10 };

/// Measures the time from its construction.
class PartClock
{
public:
  bool isOver() const { return Clock::now() - this->Begin >= partTime; }
  /// In parts of partTime.
  double elapsed() const
  {
    return std::chrono::duration<double>(Clock::now() - this->Begin) /
      std::chrono::duration<double>(partTime);
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point Begin = Clock::now();
};

/// Chooses the number of items of each part from the time that the previous part took.
class Pace
{
public:
  explicit Pace(
    std::size_t firstItems = mostItemsPerPart / 16, std::size_t mostItems = mostItemsPerPart)
    : Most(mostItems)
    , Items(firstItems)
  {
  }

  std::size_t items() const { return this->Items; }

  /// The last part took so long (PartClock::elapsed()).
  void adjust(double elapsed)
  {
    const double factor = std::clamp(1.0 / std::max(elapsed, 1e-3), 0.25, 4.0);
    this->Items = std::clamp<std::size_t>(
      static_cast<std::size_t>(static_cast<double>(this->Items) * factor), 1, this->Most);
  }

private:
  std::size_t Most;
  std::size_t Items;
};
}

#endif
