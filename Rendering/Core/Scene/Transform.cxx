// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Transform.h"

#include "Chunks.h"

#include <algorithm>

namespace lambent
{
namespace
{
template <typename Map>
void mapTuples(const Map& map, const TupleSpan& tuples, const Parallel& parallel, double* mapped)
{
  constexpr std::size_t tuplesPerChunk = 16 * 1024;
  forEachChunk<tuplesPerChunk>(parallel, tuples.size,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t k = begin; k < end; ++k)
      {
        const Vec3 result = map(tuples[k]);
        std::copy_n(&result.x, 3, mapped + 3 * k);
      }
    });
}

/// The exponent of the power of two next above the largest magnitude of the linear part.
int largestExponent(const Transform& transform)
{
  double largest = 0.0;
  for (const auto& row : transform.rows)
  {
    for (int k = 0; k < 3; ++k)
    {
      largest = std::max(largest, std::abs(row[k]));
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return exponent;
}
}

bool Transform::isIdentity() const
{
  const Transform identity;
  return std::equal(&this->rows[0][0], &this->rows[0][0] + 12, &identity.rows[0][0]);
}

Cofactors::Cofactors(const Transform& transform)
{
  const int exponent = largestExponent(transform);
  double s[3][3];
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      s[i][k] = std::ldexp(transform.rows[i][k], -exponent);
    }
  }
  double sum[3]; // of the magnitudes of each of the first row's cofactors
  for (int i = 0; i < 3; ++i)
  {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int k = 0; k < 3; ++k)
    {
      const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
      const double a = s[i1][k1] * s[i2][k2], b = s[i1][k2] * s[i2][k1];
      this->Rows[i][k] = a - b;
      sum[k] = i == 0 ? std::abs(a) + std::abs(b) : sum[k];
    }
  }
  const double determinant =
    (s[0][0] * this->Rows[0][0] + s[0][1] * this->Rows[0][1]) + s[0][2] * this->Rows[0][2];
  const double terms =
    (std::abs(s[0][0]) * sum[0] + std::abs(s[0][1]) * sum[1]) + std::abs(s[0][2]) * sum[2];
  this->IsSingular = !(std::abs(determinant) > 0x1p-48 * terms);
  this->IsMirror = determinant < 0.0;
  for (auto& row : this->Rows)
  {
    for (double& cofactor : row)
    {
      cofactor = this->IsMirror ? -cofactor : cofactor;
    }
  }
}

TransformDefect defectOf(const Transform& transform)
{
  for (const auto& row : transform.rows)
  {
    if (!std::all_of(row, row + 4, [](double value) { return std::isfinite(value); }))
    {
      return TransformDefect::NotFinite;
    }
  }
  return Cofactors(transform).isSingular() ? TransformDefect::Singular : TransformDefect::None;
}

void transformPoints(const Transform& transform, const TupleSpan& points, const Parallel& parallel,
  double* transformed)
{
  mapTuples(transform, points, parallel, transformed);
}

void transformNormals(const Cofactors& cofactors, const TupleSpan& normals,
  const Parallel& parallel, double* transformed)
{
  mapTuples(cofactors, normals, parallel, transformed);
}
}
