// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The formulas of lines and points: LineContract.h, and the surface points on them.
#include "FilmPicture.h"
#include "LineBounds.h"
#include "RandomNumbers.h"
#include "SurfacePoints.h"

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

/// A picture of 64 x 64 pixels of size 1 in a parallel view along -z, whose rays are at halves.
struct OnRays
{
  std::vector<double> points;
  std::vector<std::int32_t> corners;
  RandomScene random;

  OnRays(const std::vector<Vec3>& ends, double width, double scale = 1.0)
  {
    this->random.width = this->random.height = 64;
    Camera& camera = this->random.scene.camera;
    camera.position = { 0.0, 0.0, 50.0 * scale };
    camera.focalPoint = Vec3(0.0);
    camera.parallel = true;
    camera.parallelScale = 32.0 * scale;
    for (const Vec3& end : ends)
    {
      this->corners.push_back(static_cast<std::int32_t>(this->points.size() / 3));
      this->points.insert(this->points.end(), { end.x * scale, end.y * scale, end.z * scale });
    }
    Surface surface;
    surface.points = { this->points.data(), true, ends.size() };
    surface.corners = { this->corners.data(), false, this->corners.size() };
    surface.width = width;
    this->random.scene.surfaces = { surface };
  }

  FilmPicture picture() const
  {
    return makePicture(this->random, FilmRequest(), whole(this->random), Settings());
  }
  static bool isHit(const FilmPicture& picture, int i, int j)
  {
    return picture.primitives[64 * j + i] != noPrimitive;
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

// Rays at halves: a width of 1 covers one row, a width of 2 centred between two rows covers both.
TEST(Lines, CoverTheirWidthInPixels)
{
  for (const double width : { 1.0, 2.0, 3.0, 7.0, 50.0 })
  {
    const double y = static_cast<int>(width) % 2 ? 0.5 : 0.0;
    const OnRays scene({ { -20.5, y, 0.0 }, { 20.5, y, 0.0 } }, width - 0.001);
    const FilmPicture picture = scene.picture();
    int rows = 0, columns = 0;
    for (int k = 0; k < 64; ++k)
    {
      rows += OnRays::isHit(picture, 32, k);
      columns += OnRays::isHit(picture, k, 32);
    }
    EXPECT_EQ(rows, static_cast<int>(width)) << width;
    const double half = 0.5 * (width - 0.001);
    const double cap = std::sqrt(half * half - (0.5 - y) * (0.5 - y));
    EXPECT_EQ(columns, std::min(64, 2 * static_cast<int>(std::floor(20.5 + cap + 0.5)))) << width;
  }
}

TEST(Lines, PointsAreDiscs)
{
  const double width = 21.3;
  const OnRays scene({ { 0.2, -0.3, 0.0 }, { 0.2, -0.3, 0.0 } }, width);
  const FilmPicture picture = scene.picture();
  for (int j = 0; j < 64; ++j)
  {
    for (int i = 0; i < 64; ++i)
    {
      const double x = i - 31.5 - 0.2, y = j - 31.5 + 0.3;
      EXPECT_EQ(OnRays::isHit(picture, i, j), x * x + y * y <= 0.25 * width * width);
    }
  }
}

// The samples near a joint: all that are within half the width of the polyline are covered.
TEST(Lines, JointsHaveNoGaps)
{
  RandomNumbers random(3);
  for (int k = 0; k < 300; ++k)
  {
    const Vec3 a = random.inBox(30.0), joint = random.inBox(5.0);
    const Vec3 b = k % 2 ? random.inBox(30.0) : joint * 2.0 - a; // straight on
    const double width = random.within(1.0, 20.0);
    const FilmPicture picture = OnRays({ a, joint, joint, b }, width).picture();
    for (int j = 0; j < 64; ++j)
    {
      for (int i = 0; i < 64; ++i)
      {
        const double x = i - 31.5 - joint.x, y = j - 31.5 - joint.y;
        if (std::sqrt(x * x + y * y) < 0.5 * width - 1e-9)
        {
          ASSERT_TRUE(OnRays::isHit(picture, i, j)) << k;
        }
      }
    }
  }
}

// A line on a sloping plane: at every scale the same pixels show the line.
TEST(Lines, OnAPlaneAreVisibleAtEveryScale)
{
  for (const double slope : { 0.0, 0.5, -1.0, 3.0 })
  {
    std::vector<std::uint32_t> first;
    for (const double scale : { 1e-6, 1.0, 1e7 })
    {
      OnRays scene({ { -25.0, 5.3, slope * 5.3 }, { 25.0, -7.1, slope * -7.1 } }, 3.0, scale);
      std::vector<double> plane;
      for (const double corner : { -60.0, 60.0 })
      {
        plane.insert(plane.end(), { -60.0 * scale, corner * scale, slope * corner * scale });
        plane.insert(plane.end(), { 60.0 * scale, corner * scale, slope * corner * scale });
      }
      const std::int32_t corners[] = { 0, 1, 2, 1, 3, 2 };
      Surface face;
      face.points = { plane.data(), true, 4 };
      face.corners = { corners, false, 6 };
      const FilmPicture alone = scene.picture();
      scene.random.scene.surfaces.push_back(face);
      const FilmPicture both = scene.picture();
      const auto count = [](const FilmPicture& picture)
      { return std::count(picture.primitives.begin(), picture.primitives.end(), 0u); };
      EXPECT_GE(2 * count(both), count(alone)) << slope << ", " << scale;
      if (slope == 0.0)
      {
        EXPECT_EQ(count(both), count(alone));
      }
      if (first.empty())
      {
        first = both.primitives;
      }
      EXPECT_TRUE(both.primitives == first) << slope << ", " << scale;
      // Each column between the ends shows it.
      for (int i = 8; i < 56; ++i)
      {
        int rows = 0;
        for (int j = 0; j < 64; ++j)
        {
          rows += both.primitives[64 * j + i] == 0;
        }
        EXPECT_GE(rows, 1) << slope << ", " << scale << ", column " << i;
      }
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
      const double wide = ray < 5 ? 1.0 : random.within(0.0, 1.5);
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
        continue;
      }
      ++hits;
      ASSERT_TRUE(bounds.x().low <= x && x <= bounds.x().high) << k;
      ASSERT_TRUE(bounds.y().low <= y && y <= bounds.y().high) << k;
      ASSERT_TRUE(inRow.low <= x && x <= inRow.high) << k;
      ASSERT_FALSE(isMissed) << k;
      ASSERT_LE(bounds.nearest(), hit.depth) << k;
    }
  }
  EXPECT_GT(hits, 500000);
  EXPECT_GT(rows, 10000);
}

namespace
{
/// The surface point of the ray through a pixel of a scene with one line.
SurfacePoint pointIn(const OnRays& scene, int i, int j)
{
  const SceneMesh mesh(scene.random.scene.surfaces);
  const CameraFrame frame(scene.random.scene.camera, 64, 64);
  const FrameMesh inFrame(mesh, frame);
  return SurfacePoints(inFrame, false).at(0, frame.x(i), frame.y(j));
}

void expectNear(const Vec3& found, const Vec3& expected)
{
  EXPECT_LT(length(found - expected), 1e-12)
    << found.x << " " << found.y << " " << found.z << " instead of " << expected.x << " "
    << expected.y << " " << expected.z;
}
}

TEST(Lines, NormalsArePerpendicularAndLookAtTheViewer)
{
  const Vec3 a(-8.0, 0.5, -8.0), b(8.0, 0.5, 8.0);
  for (const bool isTurned : { false, true })
  {
    const OnRays sloping({ isTurned ? b : a, isTurned ? a : b }, 5.0);
    expectNear(pointIn(sloping, 34, 32).normal, normalized({ -1.0, 0.0, 1.0 }));
  }
  expectNear(pointIn(OnRays({ a, a }, 5.0), 24, 32).normal, { 0.0, 0.0, 1.0 });
  const Vec3 behind(-8.0, 0.5, -20.0);
  expectNear(pointIn(OnRays({ a, behind }, 5.0), 24, 32).normal, { 0.0, 0.0, 1.0 });
}

TEST(Lines, RoundedNormalsAreThoseOfATube)
{
  OnRays flat({ { -8.0, 0.5, 0.0 }, { 8.0, 0.5, 0.0 } }, 10.0);
  flat.random.scene.surfaces[0].isRounded = true;
  expectNear(pointIn(flat, 32, 35).normal, { 0.0, 0.6, 0.8 });
  expectNear(pointIn(flat, 32, 28).normal, { 0.0, -0.8, 0.6 });
  OnRays point({ { 0.5, 0.5, 0.0 }, { 0.5, 0.5, 0.0 } }, 10.0);
  point.random.scene.surfaces[0].isRounded = true;
  expectNear(pointIn(point, 35, 32).normal, { 0.6, 0.0, 0.8 });
  expectNear(pointIn(point, 32, 28).normal, { 0.0, -0.8, 0.6 });
}

TEST(Lines, GivenNormalsAreInterpolatedAndTurnedToTheViewer)
{
  const float normals[] = { 1.0f, 0.0f, 1.0f, 0.0f, 1.0f, 1.0f };
  OnRays scene({ { -8.0, 0.5, 0.0 }, { 8.0, 0.5, 0.0 } }, 5.0);
  Surface& surface = scene.random.scene.surfaces[0];
  surface.pointNormals = { normals, false, 2 };
  const SurfacePoint point = pointIn(scene, 33, 32);
  expectNear(point.weights, { 6.5 / 16.0, 9.5 / 16.0, 0.0 });
  expectNear(point.normal, { 6.5 / 16.0, 9.5 / 16.0, 1.0 });
  const float away[] = { -1.0f, 0.0f, -1.0f, 0.0f, -1.0f, -1.0f };
  surface.pointNormals = { away, false, 2 };
  expectNear(pointIn(scene, 33, 32).normal, point.normal);
  surface.appearance.shading = Shading::Flat;
  expectNear(pointIn(scene, 33, 32).normal, { 0.0, 0.0, 1.0 });
}

// Each cell counts once, however many of its lines have the point.
TEST(Lines, PointsThatAreNotFiniteAreCountedByCell)
{
  OnRays scene({ { 0.0, 0.0, 0.0 }, { notANumber, 0.0, 0.0 }, { notANumber, 0.0, 0.0 },
                 { 3.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 4.0, 0.0, 0.0 },
                 { infinite, 0.0, 0.0 }, { infinite, 0.0, 0.0 }, { 5.0, 0.0, 0.0 } },
    1.0);
  const std::int64_t cells[] = { 7, 7, 7, 7, 8 };
  scene.random.scene.surfaces[0].cells = cells;
  std::vector<unsigned char> bytes(3 * 64 * 64);
  Image image;
  image.width = image.height = 64;
  image.part = { 0, 64, 0, 64 };
  image.bytes = bytes.data();
  const MeshDefects defects = render(scene.random.scene, image).defects;
  EXPECT_EQ(defects.notFinite, 2u);
  EXPECT_EQ(defects.firstNotFinite, 0u);
  scene.corners[5] = 10;
  const Report report = render(scene.random.scene, image);
  EXPECT_EQ(report.outcome, Outcome::BadMesh);
  EXPECT_EQ(report.defects.wrongCorner, 2u);
}
