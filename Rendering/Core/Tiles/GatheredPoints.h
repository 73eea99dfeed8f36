// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief locate the points of one surface after the other, those of small ones together
 *
 * A kernel takes as long for one point as for a vector of them. So the points of surfaces that
 * have few are copied side by side first.
 */
#ifndef lambent_GatheredPoints_h
#define lambent_GatheredPoints_h

#include "LatticeKernel.h"

#include <algorithm>

namespace lambent
{
class GatheredPoints
{
public:
  explicit GatheredPoints(const PointLattice& lattice)
    : Lattice(lattice)
  {
  }

  /// The points [begin, end) of a surface; their positions are written now or by a later call.
  void locate(
    const TupleSpan& points, std::size_t begin, std::size_t end, LatticePosition* positions)
  {
    if (end - begin > few)
    {
      locatePoints(this->Lattice, points, begin, end, positions);
      return;
    }
    if (this->Count + (end - begin) > capacity || positions + begin != this->First + this->Count)
    {
      this->flush();
      this->First = positions + begin;
    }
    const std::size_t first = 3 * begin, last = 3 * end;
    double* const out = this->Coordinates + 3 * this->Count;
    points.isDouble ? std::copy(static_cast<const double*>(points.data) + first,
                        static_cast<const double*>(points.data) + last, out)
                    : std::copy(static_cast<const float*>(points.data) + first,
                        static_cast<const float*>(points.data) + last, out);
    this->Count += end - begin;
  }

  void flush()
  {
    locatePoints(
      this->Lattice, { this->Coordinates, true, this->Count }, 0, this->Count, this->First);
    this->Count = 0;
  }

private:
  static constexpr std::size_t capacity = 256, few = 32;

  const PointLattice& Lattice;
  double Coordinates[3 * capacity];
  std::size_t Count = 0;
  LatticePosition* First = nullptr; ///< where the first of them goes
};
}

#endif
