// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The formulas of lines and points, and their bounds: LineContract.h, LineBounds.h.
#include "LineBounds.h"
#include "RandomNumbers.h"

#include <gtest/gtest.h>

#include <limits>

using namespace lambent;

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();

FramePoint at(const Vec3& p, bool parallel)
{
  return { p.x, p.y, p.z, parallel ? 1.0 : p.z };
}

/// The distance of a ray from the segment between two points in front of the eye, in half widths,
/// and what follows from it, in long double and by another way: from the points in space.
struct ExactLine
{
  long double distance, depth, share;

  ExactLine(const Vec3& a, const Vec3& b, double half, bool parallel, double x, double y)
  {
    using Long = long double;
    const Long aw = parallel ? 1.0L : a.z, bw = parallel ? 1.0L : b.z;
    const Long px = a.x / aw, py = a.y / aw, qx = b.x / bw, qy = b.y / bw;
    const Long square = (qx - px) * (qx - px) + (qy - py) * (qy - py);
    const Long along =
      square > 0.0L ? ((x - px) * (qx - px) + (y - py) * (qy - py)) / square : 0.0L;
    const Long t = std::min(std::max(along, 0.0L), 1.0L);
    const Long nx = px + t * (qx - px), ny = py + t * (qy - py);
    this->distance = std::sqrt((x - nx) * (x - nx) + (y - ny) * (y - ny)) / half;
    // 1 / depth is linear on the image plane.
    const Long z = parallel ? (1.0L - t) * a.z + t * b.z : 1.0L / ((1.0L - t) / a.z + t / b.z);
    this->share = a.z == b.z ? t : (z - a.z) / (Long(b.z) - a.z);
    const Long rise = std::sqrt(std::max(1.0L - this->distance * this->distance, 0.0L));
    this->depth = z - rise * (parallel ? Long(half) : z * std::min(Long(half), 0.5L));
  }
};
}

TEST(Lines, HitsAreThoseOfLongDoubles)
{
  RandomNumbers random(1);
  int hits = 0, misses = 0;
  for (int k = 0; k < 300000; ++k)
  {
    const bool parallel = k % 3 == 0;
    const double size = std::pow(10.0, random.within(-6.0, 7.0));
    const Vec3 forward(0.0, 0.0, 1.5 * size);
    const Vec3 a = random.inBox(size) + forward;
    const Vec3 b = k % 5 == 0 ? a : random.inBox(size) + forward;
    const double half = (parallel ? size : 1.0) * std::pow(10.0, random.within(-3.0, -0.2));
    const FramePoint p = at(a, parallel), q = at(b, parallel);
    // A ray near the line.
    const double t = random.within(-0.2, 1.2);
    const double x = (p.x / p.w) * (1.0 - t) + (q.x / q.w) * t + half * random.within(-1.5, 1.5);
    const double y = (p.y / p.w) * (1.0 - t) + (q.y / q.w) * t + half * random.within(-1.5, 1.5);
    const ExactLine exact(a, b, half, parallel, x, y);
    if (std::fabs(static_cast<double>(exact.distance) - 1.0) < 1e-6)
    {
      continue;
    }
    Line line{};
    LineHit hit{};
    ASSERT_TRUE(projectLine(p, q, half, parallel, line));
    const bool isHit = intersectLine(line, x, y, hit);
    ASSERT_EQ(isHit, exact.distance < 1.0L && exact.depth > 0.0L) << k;
    misses += !isHit;
    if (isHit)
    {
      ++hits;
      ASSERT_NEAR(hit.depth, static_cast<double>(exact.depth), 1e-9 * size) << k;
      if (std::fabs(a.z - b.z) > 1e-3 * size)
      {
        ASSERT_NEAR(hit.b, static_cast<double>(exact.share), 1e-8) << k;
        ASSERT_NEAR(hit.a, static_cast<double>(1.0L - exact.share), 1e-8) << k;
      }
    }
  }
  EXPECT_GT(hits, 100000);
  EXPECT_GT(misses, 50000);
}

TEST(Lines, AreCutInFrontOfTheEye)
{
  RandomNumbers random(2);
  for (int k = 0; k < 1000; ++k)
  {
    const Vec3 a(random.within(-1.0, 1.0), random.within(-1.0, 1.0), random.within(0.5, 2.0));
    const Vec3 b(random.within(-9.0, 9.0), random.within(-9.0, 9.0), random.within(-3.0, 0.0));
    const double half = 0.01;
    Line line{}, turned{};
    ASSERT_TRUE(projectLine(at(a, false), at(b, false), half, false, line));
    ASSERT_TRUE(projectLine(at(b, false), at(a, false), half, false, turned));
    const double s = std::ldexp(a.z, -20), share = (a.z - s) / (a.z - b.z);
    EXPECT_EQ(line.az, s);
    EXPECT_EQ(line.bz, a.z);
    EXPECT_NEAR(line.aShare, 1.0 - share, 1e-12);
    EXPECT_NEAR(line.x, (a.x + share * (b.x - a.x)) / s, 1e-4);
    // The ray through a point of the line in front of the eye hits it there.
    const double along = random.within(0.0, 0.9) * share;
    const Vec3 m = a + (b - a) * along;
    LineHit hit{};
    ASSERT_TRUE(intersectLine(line, m.x / m.z, m.y / m.z, hit));
    EXPECT_NEAR(hit.b, along, 1e-6);
    EXPECT_NEAR(hit.depth, m.z * (1.0 - half), 1e-6);
    LineHit same{};
    ASSERT_TRUE(intersectLine(turned, m.x / m.z, m.y / m.z, same));
    EXPECT_EQ(same.a, hit.b); // to the bit
    EXPECT_EQ(same.b, hit.a);
    EXPECT_EQ(same.depth, hit.depth);
  }
  Line line{};
  LineHit hit{};
  EXPECT_FALSE(projectLine({ 0, 0, -1, -1 }, { 0, 0, -2, -2 }, 0.1, false, line));
  EXPECT_FALSE(projectLine({ 0, 0, 0, 0 }, { 0, 0, 0, 0 }, 0.1, false, line));
  ASSERT_TRUE(projectLine({ 0, 0, -1, 1 }, { 0, 0, -2, 1 }, 0.1, true, line));
  EXPECT_FALSE(intersectLine(line, 0.0, 0.0, hit)); // behind the eye of a parallel view
}

TEST(Lines, NotANumberIsNoHit)
{
  for (const double bad : { notANumber, infinite, -infinite })
  {
    for (const bool parallel : { false, true })
    {
      Line line{};
      LineHit hit{};
      EXPECT_FALSE(projectLine({ bad, 0, 1, 1 }, { 0, 1, 1, 1 }, 0.1, parallel, line) &&
        intersectLine(line, 0.0, 0.0, hit));
      EXPECT_FALSE(
        projectLine({ 0, 0, bad, parallel ? 1.0 : bad }, { 0, 1, 1, 1 }, 0.1, parallel, line) &&
        intersectLine(line, 0.0, 0.0, hit) && !std::isfinite(hit.depth));
      ASSERT_TRUE(projectLine({ 0, 0, 1, 1 }, { 0, 1, 1, 1 }, 0.1, parallel, line));
      EXPECT_FALSE(intersectLine(line, bad, 0.0, hit));
    }
  }
}

// Bounds may keep too much, never too little.
TEST(Lines, BoundsHoldAllHits)
{
  RandomNumbers random(4);
  int hits = 0, rejected = 0, rows = 0;
  for (int k = 0; k < 200000; ++k)
  {
    const bool parallel = k % 2 == 0;
    const double length = std::pow(10.0, random.within(-12.0, 3.0));
    const Vec3 forward(0.0, 0.0, 2.0);
    const Vec3 a = random.inBox(1.0) + forward;
    Vec3 b = a + random.inBox(length);
    b[k % 3] = k % 7 == 0 ? a[k % 3] : b[k % 3];
    const double half = std::pow(10.0, random.within(-6.0, 0.0));
    Line line{};
    if (!projectLine(at(a, parallel), at(b, parallel), half, parallel, line))
    {
      continue;
    }
    const LineBounds bounds(line);
    for (int ray = 0; ray < 10; ++ray)
    {
      // At the edge of the line, where rounding decides.
      const double t = random.within(0.0, 1.0) * (ray % 2), angle = random.within(-2.0, 2.0);
      const double u = 2.0 * angle / (1.0 + angle * angle), v = 1.0 - u * angle;
      const double wide = ray < 5 ? 1.0 : random.within(0.0, 6.0);
      const double x = line.x + (t * line.dx + wide * u) * half;
      const double y = line.y + (t * line.dy + wide * v) * half;
      LineHit hit{};
      const Interval inRow = bounds.inRow(y);
      const double size = half * std::pow(10.0, random.within(-3.0, 1.0));
      const bool isMissed = bounds.misses({ x, x + size }, { y - size, y });
      if (!intersectLine(line, x, y, hit))
      {
        rejected += isMissed;
        rows += x < inRow.low || x > inRow.high;
        ASSERT_TRUE(!(std::fabs(bounds.slope()) < 1e3) ||
          std::fabs(bounds.inRow(y + half).low - inRow.low - half * bounds.slope()) < 1e-6)
          << k;
        continue;
      }
      ++hits;
      ASSERT_TRUE(bounds.x().low <= x && x <= bounds.x().high) << k;
      ASSERT_TRUE(bounds.y().low <= y && y <= bounds.y().high) << k;
      ASSERT_FALSE(x < inRow.low || inRow.high < x) << k; // there may be none
      ASSERT_FALSE(isMissed) << k;
      ASSERT_LE(bounds.nearest(), hit.depth) << k;
    }
  }
  EXPECT_GT(hits, 400000);
  EXPECT_GT(rows, 10000);
  EXPECT_GT(rejected, 1000);
}
