// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Stopwatch_h
#define Stopwatch_h

#include <chrono>

/// Measures the wall-clock time since its construction.
class Stopwatch
{
public:
  double seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  const std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

#endif
