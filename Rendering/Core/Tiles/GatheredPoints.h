// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief locates the points of one surface after another, gathering those of small surfaces
 *
 * A kernel takes as long for one point as for a whole vector. So the points of small surfaces are
 * first copied side by side.
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

  /// Locates the points [begin, end) of a surface. Their positions are written now or by a later
  /// call.
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
  LatticePosition* First = nullptr; ///< destination of the first position
};
}

#endif
