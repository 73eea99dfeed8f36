// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures of spheres. Brute force follows the formulas; instruction sets, threads, tiles, parts
// and rounds must not change a bit.
#include "BruteForceChecks.h"
#include "RandomNumbers.h"
#include "RandomSpheres.h"
#include "ThreadedParallel.h"

#include <limits>

using namespace lambent;

namespace
{
constexpr unsigned int sceneCount = 280;

/// A scene whose surfaces have an attribute of points and one of cells, and a picture of all
/// passes.
struct Subject
{
  RandomScene random;
  NumberedAttributes attributes;
  FilmRequest request;

  Subject(RandomScene scene, int samples)
    : random(std::move(scene))
    , attributes(this->random.scene)
  {
    this->request.samples = samples;
    this->request.hasAlpha = samples > 1;
    this->request.passes = NumberedAttributes::passes();
  }
};
}

// The definition, written as plainly as possible: two loops and the ray tests.
TEST(SphereScenes, TestEachPrimitiveAgainstEachRay)
{
  std::size_t hits = 0;
  for (unsigned int seed = 0; seed < 70; ++seed)
  {
    const RandomScene random = makeRandomSpheres(seed);
    const SceneMesh mesh(random.scene.surfaces);
    const CameraFrame frame(random.scene.camera, random.width, random.height);
    const FrameMesh inFrame(mesh, frame);
    const SurfacePoints points(inFrame, random.scene.twoSidedLighting);
    const LightModel light(random.scene, frame.eye);
    const FilmPicture picture = makeByBruteForce(random, FilmRequest());
    for (int pixel = 0; pixel < random.width * random.height; ++pixel)
    {
      const int i = pixel % random.width, j = pixel / random.width;
      std::uint32_t nearest = noPrimitive, number = 0;
      double least = std::numeric_limits<double>::infinity();
      for (const Surface& surface : random.scene.surfaces)
      {
        const Appearance& look = surface.appearance;
        for (std::size_t k = 0; k < surface.primitiveCount(); ++k, ++number)
        {
          const auto inView = [&](std::size_t point)
          { return frame.toFrame(surface.points[point]); };
          SphereHit hit{};
          Hit flat{};
          bool isHit;
          if (surface.radius > 0.0)
          {
            const FramePoint c = inView(k);
            const double radius =
              surface.radii ? surface.radius * surface.radii[k] : surface.radius;
            isHit = intersectSphere({ c.x, c.y, c.z, radius, !look.cullFront, !look.cullBack },
              frame.x(i), frame.y(j), frame.parallel, hit);
          }
          else
          {
            isHit = intersect(inView(surface.corners[3 * k]), inView(surface.corners[3 * k + 1]),
                      inView(surface.corners[3 * k + 2]), frame.x(i), frame.y(j), flat) &&
              !look.isCulled(flat.sum);
            hit.depth = flat.depth;
          }
          if (isHit && hit.depth < least)
          {
            least = hit.depth;
            nearest = number;
            hits += surface.radius > 0.0;
          }
        }
      }
      expectPixel(
        picture, pixel, nearest, points, light, frame.x(i), frame.y(j), describe(seed, random));
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(hits, 20000u); // guards against scenes that are hardly hit
}

TEST(SphereScenes, EqualBruteForceInEveryInstructionSet)
{
  for (unsigned int seed = 0; seed < sceneCount && !HasFailure(); ++seed)
  {
    const Subject subject(makeRandomSpheres(seed), 1);
    const FilmPicture expected = makeByBruteForce(subject.random, subject.request);
    for (const int tileShift : { 2, 5 })
    {
      Settings settings;
      settings.tileShift = tileShift;
      settings.chunk = 1 + seed % 100;
      expectOnAllTargets(subject.random, subject.request, expected,
        describe(seed, subject.random) + ", tile shift " + std::to_string(tileShift), settings,
        ThreadedParallel(1 + tileShift / 2));
    }
  }
}

TEST(SphereScenes, EqualBruteForceWithoutKernels)
{
  for (unsigned int seed = 0; seed < sceneCount && !HasFailure(); ++seed)
  {
    const Subject subject(makeRandomSpheres(seed), 1);
    Settings settings;
    settings.kernels = false;
    EXPECT_TRUE(makePicture(subject.random, subject.request, whole(subject.random), settings) ==
      makeByBruteForce(subject.random, subject.request))
      << describe(seed, subject.random);
  }
}

TEST(SphereScenes, EqualBruteForceWithSeveralSamples)
{
  for (unsigned int seed = 300; seed < 342 && !HasFailure(); ++seed)
  {
    const Subject subject(makeFewRandomSpheres(seed), 2 + static_cast<int>(seed % 5));
    expectOnAllTargets(subject.random, subject.request,
      makeByBruteForce(subject.random, subject.request), describe(seed, subject.random), Settings(),
      ThreadedParallel(2));
  }
}

TEST(SphereScenes, PartsEqualTheWhole)
{
  for (unsigned int seed = 400; seed < 435; ++seed)
  {
    const Subject subject(makeFewRandomSpheres(seed), 1 + static_cast<int>(seed % 3));
    expectPartEqualToTheWhole(subject.random, subject.request, seed);
  }
}

// Squares underflow, so that both the ray test and the tangents lose digits.
TEST(SphereScenes, EqualBruteForceWithTinyCoordinates)
{
  for (int exponent = -164; exponent <= -134; exponent += 5)
  {
    RandomNumbers numbers(static_cast<unsigned int>(-exponent));
    const double size = std::pow(10.0, exponent);
    std::vector<double> points;
    for (int k = 0; k < 600; ++k)
    {
      points.push_back(size * numbers.within(-1.0, 1.0) - (k % 3 == 2 ? 2.0 * size : 0.0));
    }
    Surface surface;
    surface.points = { points.data(), true, points.size() / 3 };
    surface.radius = 0.05 * size;
    RandomScene random;
    random.width = random.height = 100;
    random.scene.camera.position = Vec3(0.0);
    random.scene.camera.focalPoint = { 0.0, 0.0, -1.0 };
    random.scene.surfaces = { surface };
    EXPECT_TRUE(makePicture(random, FilmRequest(), whole(random), Settings()) ==
      makeByBruteForce(random, FilmRequest()))
      << "1e" << exponent;
  }
}

// A round has at least a million primitives.
TEST(SphereScenes, EqualSeveralRounds)
{
  RandomScene random = makeRandomSpheres(1);
  std::vector<float> points;
  for (std::size_t k = 0; k < 1500000; ++k)
  {
    const Vec3 center = random.scene.surfaces[0].points[k % 2000];
    for (int axis = 0; axis < 3; ++axis)
    {
      points.push_back(static_cast<float>(center[axis]) + 1e-3f * static_cast<float>(k / 2000 % 7));
    }
  }
  Surface& surface = random.scene.surfaces[0];
  surface.points = { points.data(), false, points.size() / 3 };
  surface.radii = ScalarSpan();
  surface.radius = 0.01;
  const Subject subject(std::move(random), 1);
  Settings manyRounds;
  manyRounds.binPages = 1;
  EXPECT_TRUE(makePicture(subject.random, subject.request, whole(subject.random), Settings()) ==
    makePicture(
      subject.random, subject.request, whole(subject.random), manyRounds, ThreadedParallel(2)));
}

// The columns need more than 15 bits.
TEST(SphereScenes, EqualBruteForceInAVeryWideImage)
{
  for (unsigned int seed = 0; seed < 2 * randomSphereKinds; ++seed)
  {
    RandomScene random = makeRandomSpheres(seed);
    random.width = 40000;
    random.height = 2;
    random.scene.camera.horizontalViewAngle = true;
    EXPECT_TRUE(makePicture(random, FilmRequest(), whole(random), Settings()) ==
      makeByBruteForce(random, FilmRequest()))
      << describe(seed, random);
  }
}

// Passes of spheres, from geometry alone.
TEST(SphereScenes, PassesShowTheSphere)
{
  std::size_t hits = 0;
  for (unsigned int seed = 0; seed < 140; seed += 7) // moderate spheres
  {
    const Subject subject(makeRandomSpheres(seed), 1);
    const Scene& scene = subject.random.scene;
    const CameraFrame frame(scene.camera, subject.random.width, subject.random.height);
    const SceneMesh mesh(scene.surfaces);
    const FilmPicture picture =
      makePicture(subject.random, subject.request, whole(subject.random), Settings());
    for (std::size_t pixel = 0; pixel < picture.primitives.size(); ++pixel)
    {
      const std::uint32_t number = picture.primitives[pixel];
      if (number == noPrimitive || mesh.partOf(number).kind() != PrimitiveKind::Sphere)
      {
        continue;
      }
      ++hits;
      const SceneMesh::Part& part = mesh.partOf(number);
      const std::size_t sphere = number - part.firstPrimitive;
      const auto value = [&](std::size_t pass, int k)
      { return picture.value(subject.request.passes[pass], pass, pixel, k); };
      const Vec3 position(value(2, 0), value(2, 1), value(2, 2));
      const Vec3 normal(value(1, 0), value(1, 1), value(1, 2));
      const Vec3 center = part.points()[sphere], outward = position - center;
      const double radius = part.surface->radiusOf(sphere);
      const double size =
        length(scene.camera.position - scene.camera.focalPoint) + length(scene.camera.position);
      EXPECT_NEAR(length(outward), radius, 1e-7 * radius + 1e-14 * size);
      EXPECT_NEAR(
        dot(frame.forward, position - frame.eye), value(0, 0), 1e-12 * (value(0, 0) + size));
      const bool isInside =
        dot(outward, frame.parallel ? frame.forward : normalized(position - frame.eye)) >
        1e-5 * radius;
      const Vec3 expected =
        outward * ((isInside && scene.twoSidedLighting ? -1.0 : 1.0) / length(outward));
      EXPECT_LT(length(normal - expected), 1e-5 + 1e-14 * size / radius)
        << describe(seed, subject.random);
      EXPECT_EQ(value(3, 0), static_cast<double>(7 * sphere % 1001) - 0.25);
      EXPECT_TRUE(std::isnan(value(4, 0)));
    }
  }
  EXPECT_GT(hits, 5000u);
}
