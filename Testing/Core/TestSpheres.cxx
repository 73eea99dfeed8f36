// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The ray-sphere test of the image contract.
#include "FilmPicture.h"
#include "RandomNumbers.h"

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

/// A sphere in a parallel view along -z, with pixels of size 1 whose rays are at halves.
struct OnRays
{
  const double center[3] = { 0.5, -0.5, -7.0 };
  double Radius = 0.0;
  RandomScene random;

  explicit OnRays(double radius)
  {
    this->random.width = this->random.height = 64;
    Camera& camera = this->random.scene.camera;
    camera.position = { 0.0, 0.0, 50.0 };
    camera.focalPoint = Vec3(0.0);
    camera.parallel = true;
    camera.parallelScale = 32.0;
    Surface surface;
    surface.points = { this->center, true, 1 };
    surface.radius = 1.0;
    this->Radius = radius;
    surface.radii = { &this->Radius, true, 1 };
    this->random.scene.surfaces = { surface };
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

// Whole numbers decide which pixels a sphere covers.
TEST(Spheres, CoverAnExactDisc)
{
  for (const int squaredRadius : { 9, 25, 100, 169, 625 })
  {
    const OnRays scene(std::sqrt(static_cast<double>(squaredRadius)));
    const FilmPicture picture =
      makePicture(scene.random, FilmRequest(), whole(scene.random), Settings());
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

// A ray goes exactly through the centre.
TEST(Spheres, NeedAPositiveRadius)
{
  for (const double radius : { 1e-20, 0.0, -0.0, -1e-20, -5.0, notANumber })
  {
    const OnRays scene(radius);
    const std::size_t hits = radius > 0.0 ? 1 : 0;
    const auto count = [](const FilmPicture& picture)
    {
      return picture.primitives.size() -
        std::count(picture.primitives.begin(), picture.primitives.end(), noPrimitive);
    };
    EXPECT_EQ(
      count(makePicture(scene.random, FilmRequest(), whole(scene.random), Settings())), hits)
      << radius;
    EXPECT_EQ(count(makeByBruteForce(scene.random, FilmRequest())), hits) << radius;
  }
}
