// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The ray-sphere test of the image contract, and the boxes of samples around spheres.
#include "Bounds.h"
#include "FilmPicture.h"
#include "InstructionSets.h"
#include "RandomNumbers.h"
#include "SphereBoxKernel.h"

#include <limits>

using namespace lambent;

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();

Sphere at(double x, double y, double z, double radius)
{
  return { x, y, z, radius, true, true };
}

/// The roots in long double, in the classroom form. Returns false if the ray is close to tangent.
struct ExactRoots
{
  long double discriminant, least, most;

  ExactRoots(const Sphere& s, double x, double y, bool parallel)
  {
    using Long = long double;
    const Long d[3] = { parallel ? 0.0L : x, parallel ? 0.0L : y, 1.0L };
    const Long f[3] = { (parallel ? Long(x) : 0.0L) - s.x, (parallel ? Long(y) : 0.0L) - s.y,
      -Long(s.z) };
    const Long a = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const Long b = f[0] * d[0] + f[1] * d[1] + f[2] * d[2];
    const Long c = f[0] * f[0] + f[1] * f[1] + f[2] * f[2] - Long(s.radius) * s.radius;
    this->discriminant = b * b - a * c;
    const Long root = std::sqrt(std::max(this->discriminant, 0.0L));
    this->least = (-b - root) / a;
    this->most = (-b + root) / a;
    this->discriminant /= a * s.radius * s.radius; // 1 through the centre, 0 along the silhouette
  }
};
}

TEST(Spheres, HitsAreThoseOfLongDoubles)
{
  RandomNumbers random(1);
  int hits = 0, insides = 0, misses = 0;
  for (int k = 0; k < 200000; ++k)
  {
    const bool parallel = k % 3 == 0;
    const double size = std::pow(10.0, random.within(-3.0, 3.0));
    const Vec3 c = random.inBox(size);
    const Sphere s = at(c.x, c.y, c.z, size * std::pow(10.0, random.within(-2.0, 0.5)));
    const double scale = parallel ? size : 1.0;
    const double x = scale * random.within(-1.0, 1.0), y = scale * random.within(-1.0, 1.0);
    const ExactRoots exact(s, x, y, parallel);
    if (std::fabs(static_cast<double>(exact.discriminant)) < 1e-6)
    {
      continue;
    }
    SphereHit hit{};
    const bool isHit = intersectSphere(s, x, y, parallel, hit);
    const bool isOutside = exact.discriminant > 0.0L && exact.least > 0.0L;
    const bool isInside = exact.discriminant > 0.0L && !isOutside && exact.most > 0.0L;
    ASSERT_EQ(isHit, isOutside || isInside) << k;
    misses += !isHit;
    if (isHit)
    {
      const auto depth = static_cast<double>(isInside ? exact.most : exact.least);
      ASSERT_EQ(hit.isInside, isInside) << k;
      ASSERT_NEAR(hit.depth, depth, 1e-11 * depth + 1e-12 * size) << k;
      (isInside ? insides : hits) += 1;
    }
  }
  EXPECT_GT(hits, 4000);
  EXPECT_GT(insides, 10000);
  EXPECT_GT(misses, 10000);
}

// Far away, the classroom form loses all digits of the radius.
TEST(Spheres, DistantSpheresKeepTheirOutline)
{
  for (const bool parallel : { false, true })
  {
    const double distance = 1e9;
    const Sphere s = at(0.0, 0.0, distance, 1.0);
    const double unit = parallel ? 1.0 : 1.0 / distance;
    SphereHit hit{};
    for (double x = 0.0; x < 0.9999; x += 0.0625)
    {
      ASSERT_TRUE(intersectSphere(s, x * unit, 0.0, parallel, hit)) << x;
      EXPECT_NEAR(hit.depth, distance - std::sqrt(1.0 - x * x), 1e-6);
      EXPECT_TRUE(intersectSphere(s, 0.0, -x * unit, parallel, hit));
    }
    EXPECT_TRUE(intersectSphere(s, 0.99999 * unit, 0.0, parallel, hit));
    EXPECT_FALSE(intersectSphere(s, 1.00001 * unit, 0.0, parallel, hit));
    EXPECT_FALSE(intersectSphere(s, 0.8 * unit, 0.61 * unit, parallel, hit));
  }
}

// A ray that only touches a sphere misses it. All numbers here are exact.
TEST(Spheres, TangentsMiss)
{
  SphereHit hit{};
  for (const double x : { 1.0, -1.0 })
  {
    EXPECT_FALSE(intersectSphere(at(0.0, 0.0, 5.0, 1.0), x, 0.0, true, hit));
    EXPECT_TRUE(intersectSphere(at(0.0, 0.0, 5.0, 1.0), std::nextafter(x, 0.0), 0.0, true, hit));
  }
  EXPECT_FALSE(intersectSphere(at(2.0, 0.0, 5.0, 2.0), 0.0, 0.0, false, hit));
}

TEST(Spheres, SidesThatAreNotDrawnLetRaysThrough)
{
  for (const bool parallel : { false, true })
  {
    Sphere s = at(0.0, 0.0, 5.0, 2.0);
    SphereHit hit{};
    ASSERT_TRUE(intersectSphere(s, 0.0, 0.0, parallel, hit));
    EXPECT_EQ(hit.depth, 3.0);
    EXPECT_FALSE(hit.isInside);
    s.hasInside = false;
    ASSERT_TRUE(intersectSphere(s, 0.0, 0.0, parallel, hit));
    EXPECT_EQ(hit.depth, 3.0);
    s.hasInside = true;
    s.hasOutside = false;
    ASSERT_TRUE(intersectSphere(s, 0.0, 0.0, parallel, hit));
    EXPECT_EQ(hit.depth, 7.0);
    EXPECT_TRUE(hit.isInside);
    s.hasInside = false;
    EXPECT_FALSE(intersectSphere(s, 0.0, 0.0, parallel, hit));
    // Seen from within.
    s = at(0.0, 0.0, -1.0, 4.0);
    ASSERT_TRUE(intersectSphere(s, 0.0, 0.0, parallel, hit));
    EXPECT_EQ(hit.depth, 3.0);
    EXPECT_TRUE(hit.isInside);
    s.hasInside = false;
    EXPECT_FALSE(intersectSphere(s, 0.0, 0.0, parallel, hit));
    // Behind the eye.
    EXPECT_FALSE(intersectSphere(at(0.0, 0.0, -5.0, 4.0), 0.0, 0.0, parallel, hit));
    EXPECT_FALSE(intersectSphere(at(0.0, 0.0, -4.0, 4.0), 0.0, 0.0, parallel, hit));
  }
}

TEST(Spheres, BadNumbersAreNotHit)
{
  SphereHit hit{};
  for (const bool parallel : { false, true })
  {
    for (const double radius : { 0.0, -0.0, -1.0, notANumber, infinite, -infinite, 1e-200, 1e200 })
    {
      EXPECT_FALSE(intersectSphere(at(0.0, 0.0, 5.0, radius), 0.0, 0.0, parallel, hit)) << radius;
    }
    for (const double bad : { notANumber, infinite, -infinite })
    {
      EXPECT_FALSE(intersectSphere(at(bad, 0.0, 5.0, 1.0), 0.0, 0.0, parallel, hit));
      EXPECT_FALSE(intersectSphere(at(0.0, bad, 5.0, 1.0), 0.0, 0.0, parallel, hit));
      EXPECT_FALSE(intersectSphere(at(0.0, 0.0, bad, 1.0), 0.0, 0.0, parallel, hit));
    }
  }
}

// In a parallel view with pixels of size 1, whole numbers decide which pixels a sphere covers.
TEST(Spheres, CoverAnExactDisc)
{
  for (const int squaredRadius : { 9, 25, 100, 169, 625 })
  {
    const double center[3] = { 0.5, -0.5, -7.0 };
    RandomScene random;
    random.width = random.height = 64;
    random.scene.camera.position = { 0.0, 0.0, 50.0 };
    random.scene.camera.focalPoint = Vec3(0.0);
    random.scene.camera.parallel = true;
    random.scene.camera.parallelScale = 32.0;
    Surface surface;
    surface.points = { center, true, 1 };
    surface.radius = std::sqrt(static_cast<double>(squaredRadius));
    random.scene.surfaces = { surface };
    const FilmPicture picture = makePicture(random, FilmRequest(), whole(random), Settings());
    for (int j = 0; j < 64; ++j)
    {
      for (int i = 0; i < 64; ++i)
      {
        const int x = i - 32, y = j - 31; // from the centre
        EXPECT_EQ(picture.primitives[64 * j + i] == 0, x * x + y * y < squaredRadius)
          << i << ", " << j << ", " << squaredRadius;
      }
    }
  }
}

// A box contains all samples whose rays hit, and hardly more: a margin of one sample is left
// wherever it is not cut off.
TEST(Spheres, BoxesAreTight)
{
  onAllTargets(
    []()
    {
      RandomNumbers random(3);
      std::size_t boxes = 0;
      for (int k = 0; k < 3000; ++k)
      {
        Camera camera;
        camera.position = Vec3(0.0);
        camera.focalPoint = { 0.0, 0.0, -1.0 };
        camera.parallel = k % 3 == 0;
        camera.parallelScale = 1.0;
        camera.viewAngle = random.within(5.0, 60.0);
        const CameraFrame frame(camera, 60, 40);
        const PointLattice lattice(frame, { 0, 60, 0, 40 });
        ASSERT_TRUE(haveSphereBoxes(lattice));
        SphereBoxes found;
        found.count = 1;
        found.centers[0][0] = random.within(-2.0, 2.0);
        found.centers[1][0] = random.within(-2.0, 2.0);
        found.centers[2][0] = random.within(-3.0, 1.0);
        found.radii[0] = random.within(0.05, 1.5);
        findSphereBoxes(lattice, found);
        const FramePoint c =
          frame.toFrame({ found.centers[0][0], found.centers[1][0], found.centers[2][0] });
        Window hits{ 60, 0, 40, 0 };
        for (int pixel = 0; pixel < 60 * 40; ++pixel)
        {
          const int i = pixel % 60, j = pixel / 60;
          SphereHit hit{};
          if (intersectSphere(
                at(c.x, c.y, c.z, found.radii[0]), frame.x(i), frame.y(j), frame.parallel, hit))
          {
            hits = { std::min(hits.i0, i), std::max(hits.i1, i + 1), std::min(hits.j0, j),
              std::max(hits.j1, j + 1) };
            EXPECT_GE(hit.depth, found.nearest[0]);
          }
        }
        if (hits.i1 - hits.i0 < 8 || hits.j1 - hits.j0 < 8 || c.z < found.radii[0])
        {
          continue; // too small for its extreme points to be seen, or cut by the plane of the eye
        }
        ++boxes;
        EXPECT_LE(found.i0[0], hits.i0);
        EXPECT_GE(found.i1[0], hits.i1);
        EXPECT_LE(found.j0[0], hits.j0);
        EXPECT_GE(found.j1[0], hits.j1);
        if (hits.i0 > 0 && hits.i1 < 60 && hits.j0 > 0 && hits.j1 < 40)
        {
          EXPECT_GE(found.i0[0], hits.i0 - 2) << k;
          EXPECT_LE(found.i1[0], hits.i1 + 2) << k;
          EXPECT_GE(found.j0[0], hits.j0 - 2) << k;
          EXPECT_LE(found.j1[0], hits.j1 + 2) << k;
        }
      }
      EXPECT_GT(boxes, 500u);
    });
}

TEST(Spheres, BehindTheEyeAreDropped)
{
  Camera camera;
  camera.position = Vec3(0.0);
  camera.focalPoint = { 0.0, 0.0, -1.0 };
  for (const bool parallel : { false, true })
  {
    camera.parallel = parallel;
    const PointLattice lattice(CameraFrame(camera, 30, 20), { 0, 30, 0, 20 });
    SphereBoxes boxes;
    boxes.count = 2;
    boxes.centers[2][0] = boxes.centers[2][1] = 2.0; // behind
    boxes.radii[0] = 1.9;
    boxes.radii[1] = 2.5;
    findSphereBoxes(lattice, boxes);
    EXPECT_LE(boxes.i1[0], boxes.i0[0]);
    EXPECT_EQ(boxes.i0[1], 0);
    EXPECT_EQ(boxes.i1[1], 30);
  }
}

TEST(Spheres, BoundsIncludeTheRadius)
{
  const float points[9] = { 1, 2, 3, -4, 5, 6, 0, 0, 0 };
  const double radii[3] = { 1.0, 2.0, notANumber };
  Surface surface;
  surface.points = { points, false, 3 };
  surface.radius = 2.0;
  surface.radii = { radii, true, 3 };
  const Bounds bounds = findBounds({ surface }, Parallel());
  EXPECT_EQ(bounds.low, Vec3(-8, 0, 1));
  EXPECT_EQ(bounds.high, Vec3(3, 9, 10));
}

// As for triangles: counted, and not drawn.
TEST(Spheres, CentersThatAreNotFiniteAreReported)
{
  const double points[9] = { 0, 0, 0, infinite, 0, 0, 0, notANumber, 0 };
  RandomScene random;
  random.width = random.height = 16;
  Surface surface;
  surface.points = { points, true, 3 };
  surface.radius = 0.5;
  random.scene.camera.position = { 0.0, 0.0, 5.0 };
  random.scene.surfaces = { surface };
  std::vector<std::uint32_t> primitives(256);
  Image image;
  image.width = image.height = 16;
  image.part = whole(random);
  std::vector<float> floats(3 * primitives.size());
  image.floats = floats.data();
  image.primitives = primitives.data();
  for (const Settings& settings : { Settings(), Settings::bruteForce(image.part) })
  {
    const Report report = render(random.scene, image, Parallel(), nullptr, settings);
    EXPECT_EQ(report.outcome, Outcome::Done);
    EXPECT_EQ(report.defects.notFinite, 2u);
    EXPECT_EQ(report.defects.firstNotFinite, 1u);
  }
}
