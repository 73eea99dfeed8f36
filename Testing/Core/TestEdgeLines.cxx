// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The formulas of edges, compared with long double.
#include "EdgeLines.h"
#include "RandomNumbers.h"

#include <gtest/gtest.h>

#include <limits>

using namespace lambent;

namespace
{
using Long = long double;

Long squaredDistance(const EdgeLine& line, double x, double y)
{
  const Long dx = Long(line.bx) - line.ax, dy = Long(line.by) - line.ay;
  const Long px = Long(x) - line.ax, py = Long(y) - line.ay;
  const Long along = (px * dx + py * dy) / (dx * dx + dy * dy);
  const Long t = std::min(std::max(along, Long(0)), Long(1));
  return (px - t * dx) * (px - t * dx) + (py - t * dy) * (py - t * dy);
}

FramePoint inPerspective(double x, double y, double z)
{
  return { x, y, z, z };
}
}

TEST(EdgeLines, DistancesEqualThoseOfLongDouble)
{
  RandomNumbers random(1);
  for (int k = 0; k < 100000; ++k)
  {
    const double size = k % 3 == 0 ? 1e-6 : k % 3 == 1 ? 1.0 : 1e7;
    const Vec3 a = random.inBox(size), b = random.inBox(size), p = random.inBox(1.5 * size);
    const EdgeLine line{ a.x, a.y, b.x, b.y };
    EXPECT_NEAR(line.squaredDistance(p.x, p.y) / (size * size),
      static_cast<double>(squaredDistance(line, p.x, p.y) / (Long(size) * size)), 1e-14);
  }
}

TEST(EdgeLines, HaveRoundEnds)
{
  const EdgeLine line{ 1.0, 2.0, 5.0, 2.0 };
  EXPECT_EQ(line.squaredDistance(3.0, 4.0), 4.0);
  EXPECT_EQ(line.squaredDistance(1.0, 4.0), 4.0);
  EXPECT_EQ(line.squaredDistance(-2.0, 6.0), 25.0);
  EXPECT_EQ(line.squaredDistance(8.0, -2.0), 25.0);
  EXPECT_TRUE(line.isAt(3.0, 1.5, 0.25)); // exactly half the width away
  EXPECT_FALSE(line.isAt(3.0, std::nextafter(1.5, 0.0), 0.25));
  EXPECT_TRUE(line.isAt(4.0, 2.0, 0.0));
}

TEST(EdgeLines, WithoutLengthAreDots)
{
  const EdgeLine dot{ 1.0, 2.0, 1.0, 2.0 };
  EXPECT_EQ(dot.squaredDistance(4.0, 6.0), 25.0);
  EXPECT_EQ(dot.squaredDistance(1.0, 2.0), 0.0);
}

TEST(EdgeLines, AreNowhereWithNaN)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const EdgeLine lines[] = { { nan, 0, 1, 1 }, { 0, nan, 1, 1 }, { 0, 0, nan, 1 },
    { 0, 0, 1, nan } };
  for (const EdgeLine& line : lines)
  {
    EXPECT_FALSE(line.isAt(0.5, 0.5, std::numeric_limits<double>::max()));
  }
  EXPECT_FALSE((EdgeLine{ 0, 0, 1, 1 }.isAt(nan, 0.5, std::numeric_limits<double>::max())));
}

TEST(EdgeLines, AreDividedByTheDepthInPerspective)
{
  EdgeLine line{};
  ASSERT_TRUE(projectEdge(inPerspective(3, -6, 2), inPerspective(1, 5, 4), false, line));
  EXPECT_EQ(line.ax, 1.5);
  EXPECT_EQ(line.ay, -3.0);
  EXPECT_EQ(line.bx, 0.25);
  EXPECT_EQ(line.by, 1.25);
}

TEST(EdgeLines, AreNotDividedOrCutInAParallelView)
{
  EdgeLine line{};
  ASSERT_TRUE(projectEdge({ 3, -6, -2, 1 }, { 1, 5, -4, 1 }, true, line));
  EXPECT_EQ(line.ax, 3.0);
  EXPECT_EQ(line.ay, -6.0);
  EXPECT_EQ(line.bx, 1.0);
  EXPECT_EQ(line.by, 5.0);
}

TEST(EdgeLines, BehindTheEyeAreNotThere)
{
  EdgeLine line{};
  EXPECT_FALSE(projectEdge(inPerspective(1, 2, -1), inPerspective(3, 4, -2), false, line));
  EXPECT_FALSE(projectEdge(inPerspective(1, 2, 0), inPerspective(3, 4, -2), false, line));
  EXPECT_FALSE(projectEdge(inPerspective(1, 2, 0), inPerspective(3, 4, 0), false, line));
}

TEST(EdgeLines, AreCutBeforeTheEye)
{
  const double inFront[3] = { 0.25, -0.5, 2.0 };
  for (const double depth : { 0x1p-20, 0x1p-25, 0.0, -1.0, -100.0 })
  {
    const FramePoint far = inPerspective(inFront[0], inFront[1], inFront[2]);
    const FramePoint near = inPerspective(1.0, 3.0, depth);
    const Long cut = 0x1p-19L;
    const Long s = (Long(far.z) - cut) / (Long(far.z) - near.z);
    const Long x = (far.x + s * (Long(near.x) - far.x)) / cut;
    const Long y = (far.y + s * (Long(near.y) - far.y)) / cut;
    EdgeLine line{};
    ASSERT_TRUE(projectEdge(far, near, false, line));
    EXPECT_EQ(line.ax, 0.125);
    EXPECT_EQ(line.ay, -0.25);
    EXPECT_NEAR(line.bx / static_cast<double>(x), 1.0, 1e-14);
    EXPECT_NEAR(line.by / static_cast<double>(y), 1.0, 1e-14);
    EdgeLine turned{};
    ASSERT_TRUE(projectEdge(near, far, false, turned));
    EXPECT_EQ(turned.ax, line.bx);
    EXPECT_EQ(turned.ay, line.by);
    EXPECT_EQ(turned.bx, line.ax);
    EXPECT_EQ(turned.by, line.ay);
  }
  EdgeLine line{}; // deep enough
  ASSERT_TRUE(projectEdge(inPerspective(1, 1, 1), inPerspective(1, 1, 0x1p-19), false, line));
  EXPECT_EQ(line.bx, 0x1p19);
}

TEST(EdgeLines, MixTheirColour)
{
  const Vec3 lit(0.25, 0.5, 1.5), edge(1.0, 0.0, 0.5);
  EXPECT_EQ(mixedWithEdge(lit, edge, 1.0), edge);
  EXPECT_EQ(mixedWithEdge(lit, edge, 0.0), lit);
  EXPECT_EQ(mixedWithEdge(lit, edge, 0.25), Vec3(0.4375, 0.375, 1.25));
}
