// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The lattice may keep too many samples for a triangle, but never too few.
#include "LatticeKernel.h"
#include "PointLattice.h"
#include "RandomNumbers.h"
#include "VectorTarget.h"

#include <gtest/gtest.h>

using namespace lambent;

namespace
{
Camera makeCamera(RandomNumbers& random, double size, const Vec3& origin)
{
  Camera camera;
  camera.position = origin + random.inBox(4.0 * size);
  camera.focalPoint = origin + random.inBox(0.3 * size);
  camera.viewUp = random.inBox(1.0);
  camera.parallel = random.below(3) == 0;
  camera.parallelScale = random.within(0.3, 2.0) * size;
  camera.windowCenter[0] = random.below(3) == 0 ? random.within(-2.0, 2.0) : 0.0;
  return camera;
}

bool isPlaced(LatticePosition p)
{
  return p.column < LatticePosition::notFinite;
}

/// Calls check(i, j, isHit, samples) for each sample of the window and each of many random
/// triangles.
template <typename Check>
void forSamplesAndTriangles(const Window& window, Check&& check)
{
  RandomNumbers random(7);
  for (int k = 0; k < 1500; ++k)
  {
    const bool isFar = k % 3 == 0;
    const Vec3 origin = isFar ? Vec3(1e7, -3e7, 5e6) : Vec3(0.0);
    const double size = isFar ? 1e-2 : 1.0;
    const CameraFrame frame(makeCamera(random, size, origin), 40, 30);
    const PointLattice lattice(frame, window);
    Vec3 points[3];
    const Vec3 center = origin + random.inBox(size);
    for (Vec3& point : points)
    {
      point = center + random.inBox(random.below(2) ? size : 0.1 * size);
      if (random.below(4) == 0) // exactly or nearly on a sample's ray
      {
        const double depth = random.within(1.0, 5.0) * size;
        point =
          frame.eye + frame.fromEye(frame.x(random.below(40)), frame.y(random.below(30)), depth);
      }
    }
    LatticePosition p[3];
    FramePoint q[3];
    for (int c = 0; c < 3; ++c)
    {
      p[c] = lattice.locate(points[c]);
      q[c] = frame.toFrame(points[c]);
    }
    if (isPlaced(p[0]) && isPlaced(p[1]) && isPlaced(p[2]))
    {
      const Window samples = lattice.samplesBetween(p[0], p[1], p[2]);
      EXPECT_TRUE(samples.i0 >= 0 && samples.i1 <= window.width());
      EXPECT_TRUE(samples.j0 >= 0 && samples.j1 <= window.height());
      for (int j = 0; j < window.height(); ++j)
      {
        for (int i = 0; i < window.width(); ++i)
        {
          Hit hit;
          check(i, j,
            intersect(q[0], q[1], q[2], frame.x(window.i0 + i), frame.y(window.j0 + j), hit),
            samples);
        }
      }
    }
  }
}

/// Adds all triangles but the first to two existing ones, and checks the result.
void expectAdded(
  const IndexSpan& corners, std::size_t points, bool isSound, const std::string& target)
{
  constexpr std::int32_t offset = 70000;
  const std::size_t end = corners.size / 3;
  LatticeBoxes boxes;
  const std::int32_t before[] = { 0, 1, 2, 2, 1, 0 };
  EXPECT_TRUE(addCorners({ before, false, 6 }, 0, 2, 3, 0, boxes));
  EXPECT_EQ(addCorners(corners, 1, end, points, offset, boxes), isSound)
    << (corners.is64Bit ? "64" : "32") << " bits, " << target;
  EXPECT_EQ(boxes.count, isSound ? static_cast<int>(end + 1) : 2);
  EXPECT_TRUE(std::equal(before, before + 6, boxes.corners));
  for (std::size_t k = 3; isSound && k < corners.size; ++k)
  {
    EXPECT_EQ(boxes.corners[3 + k], static_cast<std::int32_t>(corners[k]) + offset) << target;
  }
}
}

TEST(PointLattice, KeepsEverySampleThatHits)
{
  for (const Window& window : { Window{ 0, 40, 0, 30 }, Window{ 7, 23, 11, 12 } })
  {
    int hits = 0;
    forSamplesAndTriangles(window,
      [&](int i, int j, bool isHit, const Window& samples)
      {
        if (isHit)
        {
          ++hits;
          EXPECT_TRUE(i >= samples.i0 && i < samples.i1 && j >= samples.j0 && j < samples.j1)
            << "sample " << i << ", " << j;
        }
      });
    EXPECT_GT(hits, 1000);
  }
}

// A point between two samples is located between these two, so that a triangle between samples is
// dropped.
TEST(PointLattice, LocatesPointsBetweenSamples)
{
  const Window window{ 5, 35, 3, 30 };
  RandomNumbers random(8);
  for (int k = 0; k < 5000; ++k)
  {
    const CameraFrame frame(makeCamera(random, 1.0, Vec3(0.0)), 40, 30);
    const PointLattice lattice(frame, window);
    const int i = random.below(50) - 5, j = random.below(40) - 5;
    const double depth = random.within(1.0, 5.0);
    const Vec3 point = frame.eye +
      frame.fromEye(frame.x(i) + random.within(0.01, 0.99) * frame.pixel,
        frame.y(j) + random.within(0.01, 0.99) * frame.pixel, depth);
    const LatticePosition p = lattice.locate(point);
    EXPECT_EQ(p.column, 2 * std::min(30, std::max(0, i + 1 - 5)));
    EXPECT_EQ(p.row, 2 * std::min(27, std::max(0, j + 1 - 3)));
    EXPECT_TRUE(lattice.samplesBetween(p, p, p).empty());
  }
}

// A point on a sample's ray counts as left and as right of it, whichever way its position is
// rounded.
TEST(PointLattice, PointsOnARayCountOnBothSides)
{
  RandomNumbers random(10);
  for (int k = 0; k < 5000; ++k)
  {
    const CameraFrame frame(makeCamera(random, 1.0, Vec3(0.0)), 40, 30);
    const PointLattice lattice(frame, { 0, 40, 0, 30 });
    const int i = random.below(40), j = random.below(30);
    const LatticePosition p =
      lattice.locate(frame.eye + frame.fromEye(frame.x(i), frame.y(j), random.within(1.0, 5.0)));
    EXPECT_EQ(p.column, 2 * i + 1);
    EXPECT_EQ(p.row, 2 * j + 1);
    const Window samples = lattice.samplesBetween(p, p, p);
    EXPECT_TRUE(samples.i0 == i && samples.i1 == i + 1 && samples.j0 == j && samples.j1 == j + 1);
  }
}

// Points located several at a time have the same positions as points located one by one, with
// every instruction set.
TEST(PointLattice, SeveralAtATimeEqualSinglePoints)
{
  RandomNumbers random(11);
  Camera tiny;
  tiny.parallel = true;
  tiny.parallelScale = 1e-70; // too small for precise positions
  const CameraFrame frame(makeCamera(random, 1.0, Vec3(0.0)), 40, 30);
  const PointLattice lattices[] = { { frame, { 3, 39, 2, 29 } },
    { CameraFrame(tiny, 40, 30), { 3, 39, 2, 29 } } };
  std::vector<Vec3> points;
  for (int k = 0; k < 1003; ++k)
  {
    points.push_back(k % 3 == 0
        ? random.inBox(6.0) // on all sides of the eye
        : frame.eye + frame.fromEye(frame.x(random.below(40)), frame.y(random.below(30)), 2.0));
  }
  points[500].y = std::numeric_limits<double>::quiet_NaN();
  points[502] = frame.eye;
  points[701].x = std::numeric_limits<double>::infinity();
  std::vector<float> floats;
  for (const Vec3& p : points)
  {
    floats.insert(
      floats.end(), { static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z) });
  }
  const std::string before = vectorTargetInUse();
  for (const std::string& target : vectorTargets())
  {
    ASSERT_TRUE(useVectorTarget(target));
    for (const TupleSpan& span : { TupleSpan{ points.data(), true, points.size() },
           TupleSpan{ floats.data(), false, points.size() } })
    {
      for (const PointLattice& lattice : lattices)
      {
        std::vector<LatticePosition> positions(points.size());
        locatePoints(lattice, span, 1, points.size(), positions.data());
        for (std::size_t p = 1; p < points.size(); ++p)
        {
          const LatticePosition one = lattice.locate(span[p]);
          EXPECT_EQ(positions[p].column, one.column) << "point " << p << ", " << target;
          EXPECT_EQ(positions[p].row, one.row) << "point " << p << ", " << target;
        }
      }
    }
  }
  useVectorTarget(before);
}

// Reads indices of 32 and 64 bits, any number of them, and finds a wrong one in any position.
TEST(PointLattice, CornersAreReadAndChecked)
{
  constexpr std::size_t points = 1000, count = LatticeBoxes::capacity - 3;
  RandomNumbers random(3);
  std::vector<std::int64_t> wide(3 * count + 3);
  for (std::int64_t& id : wide)
  {
    id = random.below(points);
  }
  wide[3] = points - 1;
  const std::string before = vectorTargetInUse();
  for (const std::string& target : vectorTargets())
  {
    ASSERT_TRUE(useVectorTarget(target));
    for (const std::int64_t bad : { std::int64_t(0), std::int64_t(points), std::int64_t(-1),
           std::int64_t(1) << 32, std::numeric_limits<std::int64_t>::min() })
    {
      for (std::size_t at : { std::size_t(3), std::size_t(50), 3 * count + 2 })
      {
        std::vector<std::int64_t> ids = wide;
        ids[at] = bad;
        expectAdded({ ids.data(), true, ids.size() }, points, bad == 0, target);
        const std::vector<std::int32_t> narrow(ids.begin(), ids.end());
        if (narrow[at] == bad)
        {
          expectAdded({ narrow.data(), false, narrow.size() }, points, bad == 0, target);
        }
      }
    }
  }
  useVectorTarget(before);
}

TEST(PointLattice, MarksPointsWithoutAPosition)
{
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const PointLattice lattice(CameraFrame(Camera(), 40, 30), { 0, 40, 0, 30 });
  for (const Vec3& behind : { Vec3(0.0, 0.0, 1.0), Vec3(3.0, 4.0, 5.0), Vec3(7.0, 0.0, 1.0) })
  {
    EXPECT_EQ(lattice.locate(behind).column, LatticePosition::anywhere);
  }
  for (double bad : { notANumber, infinite, -infinite })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      Vec3 point(0.0, 0.0, -1.0);
      point[axis] = bad;
      EXPECT_EQ(lattice.locate(point).column, LatticePosition::notFinite);
    }
  }
  // So distant that the frame overflows, but still finite.
  EXPECT_EQ(lattice.locate(Vec3(1e308, 1e308, -1e308)).column == LatticePosition::notFinite, false);
}

// The view is so wide and the point so distant that its position is infinity times zero.
TEST(PointLattice, NaNPositionIsAnywhere)
{
  Camera camera;
  camera.position = Vec3(0.0);
  camera.focalPoint = { 0.0, 0.0, -1.0 };
  camera.viewUp = { -1.0, 1.0, 0.0 };
  camera.viewAngle = std::nextafter(180.0, 0.0);
  const PointLattice lattice(CameraFrame(camera, 1, 1), { 0, 1, 0, 1 });
  ASSERT_TRUE(lattice.isPrecise());
  for (const double side : { -1.7e308, 1.7e308 })
  {
    const LatticePosition wide = lattice.locate({ side, side, -1.7e308 });
    EXPECT_EQ(wide.column, LatticePosition::anywhere);
    EXPECT_EQ(wide.row, LatticePosition::anywhere);
    const LatticePosition high = lattice.locate({ side, -side, -1.7e308 });
    EXPECT_EQ(high.column, LatticePosition::anywhere);
    EXPECT_EQ(high.row, LatticePosition::anywhere);
  }
}

// Beyond 15 bits, samples are counted in groups. No sample is lost.
TEST(PointLattice, LargeImages)
{
  RandomNumbers random(9);
  for (int size : { 31999, 32000, 64001, 1000000 })
  {
    Camera camera;
    camera.parallel = true;
    const CameraFrame frame(camera, size, size);
    const Window window{ 0, size, 0, size };
    const PointLattice lattice(frame, window);
    EXPECT_TRUE(lattice.isPrecise());
    for (int k = 0; k < 3000; ++k)
    {
      const int i = random.below(size), j = random.below(size);
      const double span = random.within(0.1, 10.0) * frame.pixel;
      const auto at = [&](double dx, double dy)
      { return lattice.locate(Vec3(frame.x(i) + dx * span, frame.y(j) + dy * span, 0.0)); };
      const Window samples = lattice.samplesBetween(at(-1.0, -1.0), at(1.0, -1.0), at(0.0, 1.0));
      EXPECT_TRUE(samples.i0 <= i && i < samples.i1 && samples.j0 <= j && j < samples.j1);
      EXPECT_LE(samples.i1, size);
      EXPECT_LE(samples.j1, size);
      EXPECT_LE(samples.width(), 24 + size / 8000);
    }
  }
}
