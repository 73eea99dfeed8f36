// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures of lines and points. Brute force follows the formulas; instruction sets, threads, tiles,
// parts and rounds must not change a bit.
#include "BruteForceChecks.h"
#include "RandomColors.h"
#include "RandomLines.h"
#include "ThreadedParallel.h"

#include <limits>

using namespace lambent;

namespace
{
constexpr unsigned int sceneCount = 320;

/// A scene whose surfaces have an attribute of points and one of cells, colours from one of them,
/// and a picture of all passes.
struct Subject
{
  RandomScene random;
  NumberedAttributes attributes;
  std::unique_ptr<RandomColors> colors;
  FilmRequest request;

  Subject(RandomScene scene, int samples, unsigned int seed)
    : random(std::move(scene))
    , attributes(this->random.scene)
  {
    this->colors = std::make_unique<RandomColors>(this->random.scene, seed);
    this->request.samples = samples;
    this->request.hasAlpha = samples > 1;
    this->request.passes = NumberedAttributes::passes();
  }
};
}

// The definition, written as plainly as possible: two loops and the ray tests.
TEST(LineScenes, TestEachPrimitiveAgainstEachRay)
{
  std::size_t hits = 0;
  for (unsigned int seed = 0; seed < 80; ++seed)
  {
    const RandomScene random = makeRandomLines(seed);
    const SceneMesh mesh(random.scene.surfaces);
    const CameraFrame frame(random.scene.camera, random.width, random.height);
    const FrameMesh inFrame(mesh, frame);
    const SurfacePoints points(inFrame, random.scene.twoSidedLighting);
    const LightModel light(random.scene, frame.eye);
    const FilmPicture picture = makeByBruteForce(random, FilmRequest());
    for (int pixel = 0; pixel < random.width * random.height; ++pixel)
    {
      const int i = pixel % random.width, j = pixel / random.width;
      const double x = frame.x(i), y = frame.y(j);
      std::uint32_t nearest = noPrimitive, number = 0;
      double least = std::numeric_limits<double>::infinity();
      for (const Surface& surface : random.scene.surfaces)
      {
        for (std::size_t k = 0; k < surface.primitiveCount(); ++k, ++number)
        {
          const auto inView = [&](std::size_t corner)
          { return frame.toFrame(surface.points[surface.corners[corner]]); };
          LineHit hit{};
          Hit flat{};
          Line line{};
          const bool isLine = surface.width > 0.0;
          const bool isHit = isLine
            ? projectLine(inView(2 * k), inView(2 * k + 1), 0.5 * surface.width * frame.pixel,
                frame.parallel, line) &&
              intersectLine(line, x, y, hit)
            : intersect(inView(3 * k), inView(3 * k + 1), inView(3 * k + 2), x, y, flat) &&
              !surface.appearance.isCulled(flat.sum);
          const double depth = isLine ? hit.depth : flat.depth;
          if (isHit && depth < least)
          {
            least = depth;
            nearest = number;
            hits += isLine;
          }
        }
      }
      expectPixel(picture, pixel, nearest, points, light, x, y, describe(seed, random));
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_GT(hits, 20000u); // guards against scenes that are hardly hit
}

TEST(LineScenes, EqualBruteForceInEveryInstructionSet)
{
  for (unsigned int seed = 0; seed < sceneCount && !HasFailure(); ++seed)
  {
    const Subject subject(makeRandomLines(seed), 1, seed);
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

TEST(LineScenes, EqualBruteForceWithoutKernels)
{
  for (unsigned int seed = 0; seed < sceneCount && !HasFailure(); ++seed)
  {
    const Subject subject(makeRandomLines(seed), 1, seed);
    Settings settings;
    settings.kernels = false;
    EXPECT_TRUE(makePicture(subject.random, subject.request, whole(subject.random), settings) ==
      makeByBruteForce(subject.random, subject.request))
      << describe(seed, subject.random);
  }
}

TEST(LineScenes, EqualBruteForceWithSeveralSamples)
{
  for (unsigned int seed = 400; seed < 448 && !HasFailure(); ++seed)
  {
    const Subject subject(makeFewRandomLines(seed), 2 + static_cast<int>(seed % 5), seed);
    expectOnAllTargets(subject.random, subject.request,
      makeByBruteForce(subject.random, subject.request), describe(seed, subject.random), Settings(),
      ThreadedParallel(2));
  }
}

// A picture with n x n samples is the picture of n times the size, in which lines are n times as
// wide, averaged.
TEST(LineScenes, WidthsAreInPixelsOfThePicture)
{
  for (unsigned int seed = 500; seed < 516; ++seed)
  {
    const int n = 3;
    RandomScene random = makeFewRandomLines(seed);
    FilmRequest request;
    request.samples = n;
    const FilmPicture averaged = makePicture(random, request, whole(random), Settings());
    const int width = random.width, height = random.height;
    random.width *= n;
    random.height *= n;
    for (Surface& surface : random.scene.surfaces)
    {
      surface.width *= n;
    }
    const FilmPicture large = makePicture(random, FilmRequest(), whole(random), Settings());
    for (int j = 0; j < height; ++j)
    {
      for (int i = 0; i < width; ++i)
      {
        ASSERT_EQ(averaged.primitives[j * width + i],
          large.primitives[(n * j + n / 2) * n * width + n * i + n / 2])
          << describe(seed, random);
      }
    }
  }
}

TEST(LineScenes, PartsEqualTheWhole)
{
  for (unsigned int seed = 600; seed < 640; ++seed)
  {
    const Subject subject(makeFewRandomLines(seed), 1 + static_cast<int>(seed % 3), seed);
    expectPartEqualToTheWhole(subject.random, subject.request, seed);
  }
}

TEST(LineScenes, EqualBruteForceAtAllScales)
{
  for (int exponent = -160; exponent <= 150; exponent += 31)
  {
    RandomNumbers numbers(static_cast<unsigned int>(200 + exponent));
    const double size = std::pow(10.0, exponent);
    std::vector<double> points;
    std::vector<std::int32_t> corners;
    for (int k = 0; k < 300; ++k)
    {
      points.push_back(size * numbers.within(-1.0, 1.0) - (k % 3 == 2 ? 2.0 * size : 0.0));
      corners.push_back(k % 100);
    }
    Surface surface;
    surface.points = { points.data(), true, points.size() / 3 };
    surface.corners = { corners.data(), false, corners.size() };
    surface.width = 3.0;
    RandomScene random;
    random.width = random.height = 100;
    random.scene.camera.position = Vec3(0.0);
    random.scene.camera.focalPoint = { 0.0, 0.0, -1.0 };
    random.scene.camera.parallel = exponent % 2 != 0;
    random.scene.camera.parallelScale = size;
    random.scene.surfaces = { surface };
    const FilmPicture picture = makePicture(random, FilmRequest(), whole(random), Settings());
    EXPECT_TRUE(picture == makeByBruteForce(random, FilmRequest())) << "1e" << exponent;
    EXPECT_GT(
      10000 - std::count(picture.primitives.begin(), picture.primitives.end(), noPrimitive), 1000)
      << "1e" << exponent;
  }
}

// A round has at least a million primitives.
TEST(LineScenes, EqualSeveralRounds)
{
  RandomScene random = makeRandomLines(1);
  RandomNumbers numbers(1);
  const Vec3 center = random.scene.camera.focalPoint;
  const double size = length(center - random.scene.camera.position);
  std::vector<float> points;
  std::vector<std::int32_t> corners;
  for (int k = 0; k < 1500000; ++k)
  {
    const Vec3 point = center + numbers.inBox(0.3 * size);
    for (int axis = 0; axis < 3; ++axis)
    {
      points.push_back(static_cast<float>(point[axis]));
    }
    corners.push_back(k);
    corners.push_back(k);
  }
  Surface& surface = random.scene.surfaces[0];
  surface.points = { points.data(), false, points.size() / 3 };
  surface.corners = { corners.data(), false, corners.size() };
  surface.pointNormals = TupleSpan();
  const Subject subject(std::move(random), 1, 1);
  Settings manyRounds;
  manyRounds.binPages = 1;
  EXPECT_TRUE(makePicture(subject.random, subject.request, whole(subject.random), Settings()) ==
    makePicture(
      subject.random, subject.request, whole(subject.random), manyRounds, ThreadedParallel(2)));
}

// The columns need more than 15 bits.
TEST(LineScenes, EqualBruteForceInAVeryWideImage)
{
  for (unsigned int seed = 0; seed < 2 * randomLineKinds; ++seed)
  {
    RandomScene random = makeRandomLines(seed);
    random.width = 40000;
    random.height = 2;
    random.scene.camera.horizontalViewAngle = true;
    EXPECT_TRUE(makePicture(random, FilmRequest(), whole(random), Settings()) ==
      makeByBruteForce(random, FilmRequest()))
      << describe(seed, random);
  }
}
