// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The image contract: the ray-triangle test, bytes and floats.
#include "ImageContract.h"
#include "RandomNumbers.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

using namespace lambent;

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();

/// The point at a depth that appears at (x, y) on the image plane.
FramePoint seenAt(double x, double y, double depth, bool parallel)
{
  return parallel ? FramePoint{ x, y, depth, 1.0 }
                  : FramePoint{ x * depth, y * depth, depth, depth };
}

/// x, moved by a few units in the last place.
double nudged(double x, int steps)
{
  for (; steps != 0; steps += steps > 0 ? -1 : 1)
  {
    x = std::nextafter(x, steps > 0 ? infinite : -infinite);
  }
  return x;
}

/// Triangles around a common vertex, without gaps.
struct Fan
{
  FramePoint center;
  std::vector<FramePoint> rim;

  Fan(RandomNumbers& random, bool parallel)
  {
    const double x = random.within(-2.0, 2.0), y = random.within(-2.0, 2.0);
    this->center = seenAt(x, y, random.within(0.5, 5.0), parallel);
    const int count = 3 + random.below(6);
    const double turn = random.within(0.0, 6.28);
    for (int k = 0; k < count; ++k)
    {
      const double angle = turn + 6.283185307179586 * (k + random.within(0.0, 0.4)) / count;
      const double radius = std::pow(10.0, -random.within(0.0, 6.0));
      this->rim.push_back(seenAt(x + radius * std::cos(angle), y + radius * std::sin(angle),
        random.within(0.5, 5.0), parallel));
    }
  }

  int hits(double x, double y) const
  {
    int count = 0;
    for (std::size_t k = 0; k < this->rim.size(); ++k)
    {
      Hit hit;
      const FramePoint& next = this->rim[(k + 1) % this->rim.size()];
      // The two neighbours name their common edge in opposite orders.
      count += k % 2 ? intersect(this->center, this->rim[k], next, x, y, hit)
                     : intersect(next, this->center, this->rim[k], x, y, hit);
    }
    return count;
  }
};
}

TEST(Contract, NoRayPassesBetweenTrianglesThatShareAVertex)
{
  RandomNumbers random(1);
  int passed = 0;
  for (int k = 0; k < 500000; ++k)
  {
    const Fan fan(random, k % 2 == 0);
    const double x = nudged(fan.center.x / fan.center.w, random.below(7) - 3);
    const double y = nudged(fan.center.y / fan.center.w, random.below(7) - 3);
    passed += fan.hits(x, y) == 0;
  }
  EXPECT_EQ(passed, 0);
}

TEST(Contract, NoRayPassesBetweenTrianglesThatShareAnEdge)
{
  RandomNumbers random(2);
  int passed = 0;
  for (int k = 0; k < 500000; ++k)
  {
    const Fan fan(random, k % 2 == 0);
    const FramePoint& a = fan.center;
    const FramePoint& b = fan.rim[random.below(static_cast<int>(fan.rim.size()))];
    const double t = random.within(0.0, 0.9);
    const double x = a.x / a.w + t * (b.x / b.w - a.x / a.w);
    const double y = a.y / a.w + t * (b.y / b.w - a.y / a.w);
    passed += fan.hits(nudged(x, random.below(7) - 3), nudged(y, random.below(7) - 3)) == 0;
  }
  EXPECT_EQ(passed, 0);
}

TEST(Contract, HitHasPositionAndDepth)
{
  RandomNumbers random(3);
  for (int k = 0; k < 2000; ++k)
  {
    const bool parallel = k % 2 == 0;
    const Vec3 b(random.within(0.1, 1.0), random.within(0.1, 1.0), random.within(0.1, 1.0));
    const double sum = b.x + b.y + b.z;
    FramePoint p[3];
    for (FramePoint& point : p)
    {
      point = seenAt(
        random.within(-2.0, 2.0), random.within(-2.0, 2.0), random.within(1.0, 9.0), parallel);
    }
    // The point with these barycentric coordinates, and the ray through it.
    const auto mixed = [&](double FramePoint::*c)
    { return (b.x * p[0].*c + b.y * p[1].*c + b.z * p[2].*c) / sum; };
    const double x = mixed(&FramePoint::x) / mixed(&FramePoint::w);
    const double y = mixed(&FramePoint::y) / mixed(&FramePoint::w);
    Hit hit;
    if (std::fabs((p[1].x / p[1].w - p[0].x / p[0].w) * (p[2].y / p[2].w - p[0].y / p[0].w) -
          (p[1].y / p[1].w - p[0].y / p[0].w) * (p[2].x / p[2].w - p[0].x / p[0].w)) < 0.01)
    {
      continue; // too thin to expect accurate digits
    }
    ASSERT_TRUE(intersect(p[0], p[1], p[2], x, y, hit));
    EXPECT_NEAR(hit.e0 / hit.sum, b.x / sum, 1e-11);
    EXPECT_NEAR(hit.e1 / hit.sum, b.y / sum, 1e-11);
    EXPECT_NEAR(hit.e2 / hit.sum, b.z / sum, 1e-11);
    EXPECT_NEAR(hit.depth, mixed(&FramePoint::z), 1e-10);
  }
}

TEST(Contract, SumIsPositiveOnTheFront)
{
  const FramePoint a = seenAt(0.0, 0.0, 1.0, false), b = seenAt(1.0, 0.0, 2.0, false),
                   c = seenAt(0.0, 1.0, 3.0, false);
  Hit hit;
  ASSERT_TRUE(intersect(a, b, c, 0.25, 0.25, hit)); // counter-clockwise, y up
  EXPECT_GT(hit.sum, 0.0);
  ASSERT_TRUE(intersect(a, c, b, 0.25, 0.25, hit));
  EXPECT_LT(hit.sum, 0.0);
}

TEST(Contract, BordersBelongToTheTriangle)
{
  const FramePoint a = seenAt(0.0, 0.0, 2.0, true), b = seenAt(4.0, 0.0, 2.0, true),
                   c = seenAt(0.0, 4.0, 2.0, true);
  Hit hit;
  const double on[][2] = { { 0.0, 0.0 }, { 4.0, 0.0 }, { 0.0, 4.0 }, { 1.0, 0.0 }, { 0.0, 3.0 },
    { 2.0, 2.0 } };
  for (const auto& p : on)
  {
    EXPECT_TRUE(intersect(a, b, c, p[0], p[1], hit)) << p[0] << " " << p[1];
    EXPECT_TRUE(intersect(b, a, c, p[0], p[1], hit)) << p[0] << " " << p[1];
    EXPECT_EQ(hit.depth, 2.0);
  }
  const double tiny = std::numeric_limits<double>::denorm_min();
  const double off[][2] = { { -tiny, 1.0 }, { 1.0, -tiny }, { 2.0, std::nextafter(2.0, 3.0) },
    { 5.0, 0.0 }, { -1.0, 0.0 } };
  for (const auto& p : off)
  {
    EXPECT_FALSE(intersect(a, b, c, p[0], p[1], hit)) << p[0] << " " << p[1];
  }
}

TEST(Contract, TrianglesWithoutAreaAreNotHit)
{
  const FramePoint a = seenAt(-1.0, 0.0, 2.0, true), b = seenAt(1.0, 0.0, 2.0, true),
                   c = seenAt(3.0, 0.0, 2.0, true);
  Hit hit;
  for (double x : { -1.0, 0.0, 1.0, 2.0 })
  {
    EXPECT_FALSE(intersect(a, b, c, x, 0.0, hit));
    EXPECT_FALSE(intersect(a, a, b, x, 0.0, hit));
    EXPECT_FALSE(intersect(a, a, a, x, 0.0, hit));
  }
}

// The edge functions of such a needle round to zero far beyond its ends.
TEST(Contract, NeedlesEndAtTheirTips)
{
  RandomNumbers random(4);
  for (int k = 0; k < 100000; ++k)
  {
    const double s = random.within(0.1, 1.0), slope = random.within(-1.0, 1.0);
    const FramePoint a = seenAt(0.0, 0.0, 1.0, true), b = seenAt(s, slope * s, 1.0, true),
                     c = seenAt(s, nudged(slope * s, 1), 1.0, true);
    const double beyond = random.within(1.001, 3.0);
    Hit hit;
    EXPECT_FALSE(intersect(a, b, c, beyond * s, slope * (beyond * s), hit));
    EXPECT_FALSE(intersect(a, b, c, -beyond * s, -slope * (beyond * s), hit));
  }
}

TEST(Contract, TrianglesBehindTheEyeAreNotHit)
{
  Hit hit;
  // Behind the eye, where it would appear upside down.
  EXPECT_FALSE(intersect(
    { 1.0, 1.0, -1.0, -1.0 }, { -2.0, 1.0, -1.0, -1.0 }, { 1.0, -2.0, -1.0, -1.0 }, 0.0, 0.0, hit));
  EXPECT_FALSE(intersect(
    { 1.0, 1.0, -1.0, 1.0 }, { -2.0, 1.0, -1.0, 1.0 }, { 1.0, -2.0, -1.0, 1.0 }, 0.0, 0.0, hit));
  // In the eye's plane.
  EXPECT_FALSE(intersect(
    { 1.0, 1.0, 0.0, 0.0 }, { -2.0, 1.0, 0.0, 0.0 }, { 1.0, -2.0, 0.0, 0.0 }, 0.0, 0.0, hit));
  // A triangle that crosses this plane: only the part in front is hit.
  const FramePoint a{ -1.0, -1.0, -1.0, -1.0 }, b{ 1.0, -1.0, -1.0, -1.0 },
    c{ 0.0, -1.0, 9.0, 9.0 };
  EXPECT_TRUE(intersect(a, b, c, 0.0, -0.5, hit));
  EXPECT_NEAR(hit.depth, 2.0, 1e-12);
  EXPECT_FALSE(intersect(a, b, c, 0.0, 0.5, hit));
}

TEST(Contract, NonFiniteTrianglesAreNotHit)
{
  const FramePoint good[3] = { seenAt(-1.0, -1.0, 1.0, false), seenAt(2.0, -1.0, 1.0, false),
    seenAt(-1.0, 2.0, 1.0, false) };
  Hit hit;
  ASSERT_TRUE(intersect(good[0], good[1], good[2], 0.0, 0.0, hit));
  for (double bad : { notANumber, infinite, -infinite })
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      for (double FramePoint::*c : { &FramePoint::x, &FramePoint::y, &FramePoint::w })
      {
        FramePoint p[3] = { good[0], good[1], good[2] };
        p[corner].*c = bad;
        EXPECT_FALSE(intersect(p[0], p[1], p[2], 0.0, 0.0, hit));
      }
    }
  }
  // So distant that the sum of the depths overflows.
  EXPECT_FALSE(intersect({ -10.0, -10.0, 1e308, 1.0 }, { 20.0, -10.0, 1e308, 1.0 },
    { -10.0, 20.0, 1e308, 1.0 }, 0.0, 0.0, hit));
}

TEST(Contract, Bytes)
{
  for (int byte = 0; byte < 256; ++byte)
  {
    EXPECT_EQ(toByte(byte / 255.0), byte);
    EXPECT_EQ(toByte((byte + 0.499) / 255.0), byte);
    EXPECT_EQ(toByte((byte - 0.499) / 255.0), byte);
  }
  // Volatile, because a value that the compiler computes in advance is always clamped.
  for (volatile double bright : { std::nextafter(1.0, 2.0), 1.003, 1.5, 2.0, 1e6, 1e300, infinite })
  {
    EXPECT_EQ(toByte(bright), 255) << bright;
  }
  EXPECT_EQ(toByte(0.5), 128);
  EXPECT_EQ(toByte(-1e300), 0);
  EXPECT_EQ(toByte(-infinite), 0);
  EXPECT_EQ(toByte(1e300), 255);
  EXPECT_EQ(toByte(infinite), 255);
  EXPECT_EQ(toByte(notANumber), 0);
}

// Processors differ in the sign and the other bits of a NaN; pictures do not.
TEST(Contract, Floats)
{
  for (double value : { 0.0, -0.0, 0.1, -1e30, 1e-310, infinite, -infinite })
  {
    EXPECT_EQ(toFloat(value), static_cast<float>(value));
    EXPECT_EQ(std::signbit(toFloat(value)), std::signbit(value));
  }
  const float same = std::numeric_limits<float>::quiet_NaN();
  for (double value : { notANumber, -notANumber, std::nan("0x12345"), infinite - infinite })
  {
    const float channel = toFloat(value);
    EXPECT_EQ(std::memcmp(&channel, &same, sizeof(float)), 0);
  }
}
