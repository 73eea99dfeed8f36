// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the sums of the contributions to a range of points
 */
#ifndef lambent_PointSums_h
#define lambent_PointSums_h

#include "Arithmetic.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent
{
/// A vector, padded to the size of a register.
struct alignas(32) PointSum
{
  double x, y, z, unused;
};

/// Sums for the points begin to end - 1, and one more that receives the terms of all other points:
/// adding to it is cheaper than branching at each corner. Reuses its memory.
class PointSums
{
public:
  void reset(std::int64_t begin, std::int64_t end)
  {
    this->Begin = begin;
    this->Sums.assign(static_cast<std::size_t>(end - begin) + 1, PointSum{ 0.0, 0.0, 0.0, 0.0 });
  }

  std::int64_t begin() const { return this->Begin; }
  std::int64_t end() const { return this->Begin + static_cast<std::int64_t>(this->size()); }
  /// The number of points.
  std::size_t size() const { return this->Sums.size() - 1; }
  PointSum* data() { return this->Sums.data(); }
  const PointSum* data() const { return this->Sums.data(); }

  /// The index of a point's sum; size() for a point outside the range.
  template <typename Id>
  std::size_t place(Id point) const
  {
    const auto place = static_cast<std::size_t>(point - this->Begin);
    return place < this->size() ? place : this->size();
  }

  template <typename Id>
  void add(Id point, const Vec3& term)
  {
    PointSum& sum = this->Sums[this->place(point)];
    sum.x += term.x;
    sum.y += term.y;
    sum.z += term.z;
  }

private:
  std::int64_t Begin = 0;
  std::vector<PointSum> Sums;
};
}

#endif
