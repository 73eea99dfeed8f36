// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief affine transforms of surfaces: the definition, in the arithmetic of the image contract
 *
 * A point p becomes
 *
 *     p'_i = ((m_i0 p_x + m_i1 p_y) + m_i2 p_z) + m_i3
 *
 * in binary64, whatever the type of the original points. The identity leaves points and normals
 * untouched. A picture of a transformed surface is the picture of a surface with these points.
 *
 * A given normal is transformed by the inverse transpose of the linear part m, so that it stays
 * perpendicular to the surface. Its length does not matter, so a multiple of that matrix serves,
 * which needs no division:
 *
 * 1. s = m times the power of two that brings its largest magnitude into [1/2, 1). This is exact,
 *    and keeps the normals of very large and very small transforms from overflowing.
 * 2. The cofactors are c_ik = s_jl s_(j+1)(l+1) - s_j(l+1) s_(j+1)l, where j = i + 1, l = k + 1,
 * and all indices are modulo 3.
 * 3. The determinant is (s_00 c_00 + s_01 c_01) + s_02 c_02. If it is negative, all cofactors
 * change their signs.
 * 4. n'_i = (c_i0 n_x + c_i1 n_y) + c_i2 n_z.
 *
 * If the determinant is negative, the transform mirrors: a face that was counter-clockwise seen
 * from outside becomes clockwise. To keep the front of each face, the second and the third corner
 * of each triangle are then swapped (DrawnTriangles.h), after it was cut from its polygon, and
 * computed normals, which follow from the transformed points and the original winding, change
 * their signs.
 *
 * A transform is singular if its determinant lies within the rounding errors of 0: if it is at most
 * 2^-48 times the sum of its terms' magnitudes. Neither normals nor the front could be trusted.
 */
#ifndef lambent_Transform_h
#define lambent_Transform_h

#include "Arithmetic.h"
#include "Parallel.h"
#include "Spans.h"

namespace lambent
{
/// The rows of an affine matrix; its fourth row is 0 0 0 1.
struct Transform
{
  double rows[3][4] = { { 1.0, 0.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0, 0.0 } };

  bool isIdentity() const;

  Vec3 operator()(const Vec3& p) const
  {
    const auto coordinate = [&p](const double* m)
    { return ((m[0] * p.x + m[1] * p.y) + m[2] * p.z) + m[3]; };
    return { coordinate(this->rows[0]), coordinate(this->rows[1]), coordinate(this->rows[2]) };
  }
};

/// The matrix that transforms normals.
class Cofactors
{
public:
  /// The transform must be finite.
  explicit Cofactors(const Transform& transform);

  bool isSingular() const { return this->IsSingular; }
  bool isMirror() const { return this->IsMirror; }

  Vec3 operator()(const Vec3& n) const
  {
    const auto coordinate = [&n](const double* c)
    { return (c[0] * n.x + c[1] * n.y) + c[2] * n.z; };
    return { coordinate(this->Rows[0]), coordinate(this->Rows[1]), coordinate(this->Rows[2]) };
  }

private:
  double Rows[3][3];
  bool IsSingular;
  bool IsMirror;
};

enum class TransformDefect
{
  None,
  NotFinite,
  Singular
};
TransformDefect defectOf(const Transform& transform);

/// Writes three doubles for each tuple.
void transformPoints(const Transform& transform, const TupleSpan& points, const Parallel& parallel,
  double* transformed);
void transformNormals(const Cofactors& cofactors, const TupleSpan& normals,
  const Parallel& parallel, double* transformed);
}

#endif
