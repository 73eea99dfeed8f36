// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief find the creased points of a range: those with a face too steep for a single normal
 *
 * A face is steep at a point if the angle between the face's normal and the point's is
 * larger than half the feature angle. With the face's area vector A (Newell's), the point's
 * normal N, and the cosine c of half the feature angle, that is
 *
 *     not (A.N > 0 and (A.N)^2 >= c^2 (A.A))
 *
 * in binary64. Faces whose A.A is not usable (isUsableSquare()) are never steep. If no face
 * at a point is steep, no two of their normals differ by more than the feature angle.
 *
 * markCreases() tests several triangles at a time, with the same results.
 */
#ifndef lambent_Creases_h
#define lambent_Creases_h

#include "NormalContribution.h"
#include "Spans.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent
{
inline bool isSteep(const Vec3& area, const Vec3& normal, double squaredCosine)
{
  const double square = dot(area, area);
  const double along = dot(area, normal);
  return isUsableSquare(square) && !(along > 0.0 && along * along >= squaredCosine * square);
}

/// The normals of a range of points, and which of them are creased. Both arrays have one more
/// entry, for all points outside the range: marking it is cheaper than branching each time.
class Creases
{
public:
  explicit Creases(double halfAngleCosine)
    : squaredCosine(halfAngleCosine * halfAngleCosine)
  {
  }

  void reset(std::int64_t begin, std::int64_t end)
  {
    this->Begin = begin;
    this->Size = static_cast<std::size_t>(end - begin);
    this->normals.resize(3 * (this->Size + 1));
    this->marks.assign(this->Size + 1, 0);
  }

  std::int64_t begin() const { return this->Begin; }
  std::size_t size() const { return this->Size; }

  /// The index of a point's entries; size() for a point outside the range.
  template <typename Id>
  std::size_t place(Id point) const
  {
    return std::min(static_cast<std::size_t>(point - this->Begin), this->Size);
  }

  Vec3 normal(std::size_t place) const
  {
    const float* n = &this->normals[3 * place];
    return { n[0], n[1], n[2] };
  }

  const double squaredCosine;
  std::vector<float> normals;       ///< three per point
  std::vector<unsigned char> marks; ///< nonzero for a creased point

private:
  std::int64_t Begin = 0;
  std::size_t Size = 0;
};

/// Marks the points at which one of the triangles is steep. Triangle i has the points
/// corners[3 i] to corners[3 i + 2].
///@{
void markCreases(
  const TupleSpan& points, const std::int32_t* corners, std::size_t count, Creases& creases);
void markCreases(
  const TupleSpan& points, const std::int64_t* corners, std::size_t count, Creases& creases);
///@}
}

#endif
