// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RandomNumbers_h
#define RandomNumbers_h

#include "ImageContract.h"

#include <random>

/// Seeded random numbers, the same on every platform: the standard's generators are portable, its
/// distributions are not.
class RandomNumbers
{
public:
  explicit RandomNumbers(unsigned int seed)
    : Generator(seed)
  {
  }

  double within(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Generator() >> 11) * 0x1p-53);
  }
  int below(int n) { return static_cast<int>(this->Generator() % static_cast<unsigned int>(n)); }
  lambent::Vec3 inBox(double size)
  {
    const double x = this->within(-size, size), y = this->within(-size, size);
    return { x, y, this->within(-size, size) };
  }

private:
  std::mt19937_64 Generator;
};

#endif
