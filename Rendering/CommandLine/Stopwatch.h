// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief measures the time of each stage
 */

#ifndef Stopwatch_h
#define Stopwatch_h

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace lambent::command
{

class Stopwatch
{
public:
  using Laps = std::vector<std::pair<std::string, double>>; ///< name, milliseconds

  /// Ends a stage and begins the next.
  void Lap(const std::string& stage)
  {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double, std::milli> elapsed = now - this->Start;
    this->Times.emplace_back(stage, elapsed.count());
    this->Start = now;
  }

  const Laps& GetLaps() const { return this->Times; }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point Start = Clock::now();
  Laps Times;
};

} // namespace lambent::command

#endif
