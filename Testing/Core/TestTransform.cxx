// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomNumbers.h"
#include "ThreadedParallel.h"
#include "Transform.h"

#include <gtest/gtest.h>

#include <limits>

using namespace lambent;

namespace
{
Transform scaling(double x, double y, double z)
{
  return { { { x, 0.0, 0.0, 0.0 }, { 0.0, y, 0.0, 0.0 }, { 0.0, 0.0, z, 0.0 } } };
}

Transform randomTransform(RandomNumbers& random)
{
  Transform result;
  for (auto& row : result.rows)
  {
    for (double& value : row)
    {
      value = random.within(-2.0, 2.0);
    }
  }
  return result;
}

/// Without the offset.
Vec3 turned(Transform transform, const Vec3& direction)
{
  for (auto& row : transform.rows)
  {
    row[3] = 0.0;
  }
  return transform(direction);
}

long double determinant(const Transform& t)
{
  const auto m = [&t](int i, int k) { return static_cast<long double>(t.rows[i][k]); };
  return m(0, 0) * (m(1, 1) * m(2, 2) - m(1, 2) * m(2, 1)) -
    m(0, 1) * (m(1, 0) * m(2, 2) - m(1, 2) * m(2, 0)) +
    m(0, 2) * (m(1, 0) * m(2, 1) - m(1, 1) * m(2, 0));
}

double cosine(const Vec3& a, const Vec3& b)
{
  return dot(a, b) / (length(a) * length(b));
}
}

TEST(Transform, PointsFollowTheFormula)
{
  const Transform t{ { { 0.1, 0.2, 0.3, 0.4 }, { 1e20, 1.0, -1e20, 3.0 },
    { 7.0, 5.0, 3.0, 0.1 } } };
  const Vec3 p = t({ 0.7, 1.1, 0.7 });
  EXPECT_EQ(p.x, ((0.1 * 0.7 + 0.2 * 1.1) + 0.3 * 0.7) + 0.4);
  EXPECT_EQ(p.y, 3.0); // another order of the sum gives 1.1 + 3
  EXPECT_EQ(p.z, ((7.0 * 0.7 + 5.0 * 1.1) + 3.0 * 0.7) + 0.1);
}

TEST(Transform, OnlyTheIdentityIsIdentity)
{
  EXPECT_TRUE(Transform().isIdentity());
  for (int k = 0; k < 12; ++k)
  {
    Transform t;
    t.rows[k / 4][k % 4] += 0x1p-52;
    EXPECT_FALSE(t.isIdentity()) << k;
  }
}

// The normal of a transformed plane, computed from two transformed directions in it.
TEST(Transform, NormalsStayPerpendicularAndOnTheirSide)
{
  RandomNumbers random(3);
  int mirrors = 0;
  for (int k = 0; k < 1000; ++k)
  {
    const Transform t = randomTransform(random);
    const Cofactors cofactors(t);
    const Vec3 a = random.inBox(1.0), b = random.inBox(1.0);
    const Vec3 normal = cofactors(cross(a, b));
    EXPECT_NEAR(cosine(normal, turned(t, a)), 0.0, 1e-12);
    EXPECT_NEAR(cosine(normal, turned(t, b)), 0.0, 1e-12);
    // A direction out of the plane stays on the same side of it.
    const Vec3 c = random.inBox(1.0);
    EXPECT_GT(dot(normal, turned(t, c)) * dot(cross(a, b), c), 0.0);
    EXPECT_EQ(cofactors.isMirror(), determinant(t) < 0.0L);
    EXPECT_EQ(defectOf(t), TransformDefect::None);
    mirrors += cofactors.isMirror();
  }
  EXPECT_GT(mirrors, 300);
  EXPECT_LT(mirrors, 700);
}

// An overflow or underflow would spoil these; so the scale must not matter at all.
TEST(Transform, NormalsDoNotDependOnTheScale)
{
  RandomNumbers random(4);
  const Transform t = randomTransform(random);
  const Vec3 n = random.inBox(1.0), expected = Cofactors(t)(n);
  for (const double scale : { 0x1p-500, 0x1p-10, 0x1p10, 0x1p900 })
  {
    Transform scaled = t;
    for (auto& row : scaled.rows)
    {
      for (double& value : row)
      {
        value *= scale;
      }
    }
    const Vec3 found = Cofactors(scaled)(n);
    EXPECT_EQ(found, expected) << scale;
    EXPECT_EQ(defectOf(scaled), TransformDefect::None) << scale;
  }
}

TEST(Transform, TranslationsAndTheIdentityKeepNormals)
{
  Transform t;
  t.rows[1][3] = 1e30;
  const Vec3 n(0.1, -0.7, 0.3);
  EXPECT_EQ(Cofactors(t)(n) * 4.0, n); // scaled by 1/2 to the second
}

TEST(Transform, SingularOnesAreFound)
{
  for (const Transform& t : { scaling(1.0, 0.0, 1.0), scaling(0.0, 0.0, 0.0),
         Transform{ { { 1.0, 2.0, 3.0, 9.0 }, { 4.0, 5.0, 6.0, 9.0 }, { 7.0, 8.0, 9.0, 9.0 } } },
         Transform{ { { 0.1, 0.2, 0.3, 0.0 }, { 0.3, 0.1, 0.2, 0.0 }, { 0.4, 0.3, 0.5, 0.0 } } } })
  {
    EXPECT_EQ(defectOf(t), TransformDefect::Singular);
  }
  for (const Transform& t :
    { scaling(1.0, 1e-100, 1.0), scaling(1e-90, 1e-90, 1e-90), scaling(1e50, 1e-50, 1.0),
      scaling(-1.0, 1.0, 1.0),
      Transform{ { { 1.0, 2.0, 3.0, 9.0 }, { 4.0, 5.0, 6.0, 9.0 }, { 7.0, 8.0, 9.0001, 9.0 } } } })
  {
    EXPECT_EQ(defectOf(t), TransformDefect::None);
  }
}

// Only rounding makes the determinants of these products differ from 0.
TEST(Transform, SingularOnesAreFoundThroughRounding)
{
  RandomNumbers random(7);
  int notZero = 0;
  for (int trial = 0; trial < 1000; ++trial)
  {
    Transform t;
    const Vec3 a = random.inBox(0.25) + 0.75, b = random.inBox(0.25) + 0.75;
    const Vec3 c = random.inBox(0.25) + 0.75, d = random.inBox(0.25) + 0.75;
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        t.rows[i][k] = a[i] * b[k] + c[i] * d[k];
      }
    }
    EXPECT_EQ(defectOf(t), TransformDefect::Singular);
    notZero += determinant(t) != 0.0L;
  }
  EXPECT_GT(notZero, 900);
}

TEST(Transform, WhatIsNotFiniteIsFound)
{
  for (const double value : { std::numeric_limits<double>::infinity(),
         -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    for (int k = 0; k < 12; ++k)
    {
      Transform t;
      t.rows[k / 4][k % 4] = value;
      EXPECT_EQ(defectOf(t), TransformDefect::NotFinite) << k;
    }
  }
}

TEST(Transform, TuplesOfFloatsAndDoublesAreTransformedOneByOne)
{
  RandomNumbers random(5);
  const Transform t = randomTransform(random);
  const Cofactors cofactors(t);
  const std::size_t count = 100000;
  std::vector<float> floats;
  std::vector<double> doubles;
  for (std::size_t k = 0; k < 3 * count; ++k)
  {
    doubles.push_back(random.within(-1.0, 1.0));
    floats.push_back(static_cast<float>(doubles.back()));
  }
  const ThreadedParallel parallel(3);
  for (const TupleSpan& span :
    { TupleSpan{ floats.data(), false, count }, TupleSpan{ doubles.data(), true, count } })
  {
    std::vector<double> points(3 * count), normals(3 * count);
    transformPoints(t, span, parallel, points.data());
    transformNormals(cofactors, span, parallel, normals.data());
    for (std::size_t k = 0; k < count; ++k)
    {
      ASSERT_EQ(Vec3(points[3 * k], points[3 * k + 1], points[3 * k + 2]), t(span[k]));
      ASSERT_EQ(Vec3(normals[3 * k], normals[3 * k + 1], normals[3 * k + 2]), cofactors(span[k]));
    }
  }
}
