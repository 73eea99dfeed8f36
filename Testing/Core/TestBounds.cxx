// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bounds.h"
#include "ThreadedParallel.h"

#include <gtest/gtest.h>

using namespace lambent;

namespace
{
struct Triangle
{
  // A point that is not used, the three points of a triangle, and a NaN.
  double points[15] = { 99, 99, 99, 1, 2, 3, -4, 5, 6, 7, -8, 9,
    std::numeric_limits<double>::quiet_NaN(), 0, 0 };
  std::int64_t corners[6] = { 1, 2, 3, 3, 4, 1234 };
  Surface surface;

  Triangle()
  {
    this->surface.points = { this->points, true, 5 };
    this->surface.corners = { this->corners, true, 6 };
  }
};
}

TEST(Bounds, CoverTheFinitePointsInUse)
{
  const Triangle triangle;
  const Bounds bounds = findBounds({ triangle.surface }, Parallel());
  EXPECT_EQ(bounds.low, Vec3(-4, -8, 3));
  EXPECT_EQ(bounds.high, Vec3(7, 5, 9));
}

// Workers that get no chunk must not widen the bounds.
TEST(Bounds, DoNotDependOnIdleWorkers)
{
  const Triangle triangle;
  const Bounds bounds = findBounds({ triangle.surface }, ThreadedParallel(8));
  EXPECT_EQ(bounds.low, Vec3(-4, -8, 3));
  EXPECT_EQ(bounds.high, Vec3(7, 5, 9));
}

TEST(Bounds, AreEmptyWithoutPoints)
{
  EXPECT_TRUE(findBounds({ Surface() }, ThreadedParallel(2)).empty());
  Bounds sum;
  sum.add(Bounds());
  EXPECT_TRUE(sum.empty());
}
