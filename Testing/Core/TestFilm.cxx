// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Alpha is the fraction of a pixel's samples that hit a surface, and the colour is the mean of
// these samples. Instruction sets, threads, tiles and parts must not change a bit.
#include "FilmPicture.h"
#include "InstructionSets.h"
#include "LightModel.h"
#include "RandomNumbers.h"
#include "SurfacePoints.h"
#include "ThreadedParallel.h"

using namespace lambent;

namespace
{
FilmRequest withAlpha(int samples, bool isBytes)
{
  FilmRequest request;
  request.samples = samples;
  request.hasAlpha = true;
  request.isBytes = isBytes;
  return request;
}

/// The sum of the colours of the samples that hit a surface, and the number of these samples.
struct Sum
{
  Vec3 color{ 0.0 };
  double hits = 0.0;
};

/// Adds up the samples of a pixel, from the triangles of a larger picture with one sample per
/// pixel.
Sum addSamples(const RandomScene& larger, const std::vector<std::uint32_t>& triangles, int n,
  int pixel, const SurfacePoints& points, const LightModel& light, const CameraFrame& frame)
{
  Sum sum;
  const int columns = larger.width / n;
  for (int k = 0; k < n * n; ++k)
  {
    const int i = n * (pixel % columns) + k % n, j = n * (pixel / columns) + k / n;
    const std::uint32_t triangle = triangles[static_cast<std::size_t>(j) * larger.width + i];
    const bool isHit = triangle != noPrimitive;
    const Vec3 color = isHit ? light.color(points.at(triangle, frame.x(i), frame.y(j))) : Vec3(0.0);
    sum.color = k == 0 ? color : sum.color + color;
    sum.hits += isHit;
  }
  return sum;
}
}

// The definition, written as plainly as possible: the sum of the hits over n^2, and over alpha.
TEST(Film, StoresTheMeanColourOfTheHitsAndTheirFraction)
{
  std::size_t partial = 0;
  for (unsigned int seed = 0; seed < 80 && !HasFailure(); ++seed)
  {
    const int n = 1 + static_cast<int>(seed % 6);
    const RandomScene random = makeSmallScene(seed);
    RandomScene larger = makeSmallScene(seed);
    larger.width *= n;
    larger.height *= n;
    const std::vector<std::uint32_t> seen = makeByBruteForce(larger, FilmRequest()).primitives;
    const SceneMesh mesh(random.scene.surfaces);
    const CameraFrame frame(random.scene.camera, larger.width, larger.height);
    const FrameMesh inFrame(mesh, frame);
    const SurfacePoints points(inFrame, random.scene.twoSidedLighting);
    const LightModel light(random.scene, frame.eye);
    const FilmPicture floats = makeByBruteForce(random, withAlpha(n, false));
    const FilmPicture bytes = makeByBruteForce(random, withAlpha(n, true));
    for (int pixel = 0; pixel < random.width * random.height; ++pixel)
    {
      const double count = n * n;
      const Sum sum = addSamples(larger, seen, n, pixel, points, light, frame);
      const double alpha = sum.hits / count;
      partial += alpha > 0.0 && alpha < 1.0;
      for (int channel = 0; channel < 4; ++channel)
      {
        const double expected = channel == 3 ? alpha
          : alpha == 0.0                     ? 0.0
                                             : sum.color[channel] / count / alpha;
        EXPECT_EQ(floats.floats[4 * pixel + channel], static_cast<float>(expected))
          << "seed " << seed << ", pixel " << pixel << ", " << n << " samples";
        EXPECT_EQ(bytes.bytes[4 * pixel + channel], toByte(expected))
          << "seed " << seed << ", pixel " << pixel << ", " << n << " samples";
      }
      EXPECT_EQ(floats.primitives[pixel],
        seen[static_cast<std::size_t>(n * (pixel / random.width) + n / 2) * larger.width +
          n * (pixel % random.width) + n / 2]);
    }
  }
  EXPECT_GT(partial, 200u); // pixels at edges
}

TEST(Film, AlphaEqualsBruteForceInEveryInstructionSet)
{
  for (unsigned int seed = 100; seed < 164 && !HasFailure(); ++seed)
  {
    const RandomScene random = makeSmallScene(seed);
    const FilmRequest request = withAlpha(1 + static_cast<int>(seed % 16), seed / 16 % 2 == 0);
    const FilmPicture expected = makeByBruteForce(random, request);
    onAllTargets(
      [&]()
      {
        Settings settings;
        settings.tileShift = static_cast<int>(seed % 7); // also tiles of a single pixel
        EXPECT_TRUE(makePicture(random, request, whole(random), settings) == expected)
          << "seed " << seed;
        EXPECT_TRUE(
          makePicture(random, request, whole(random), Settings(), ThreadedParallel(3)) == expected)
          << "seed " << seed << ", three workers";
      });
  }
}

// The pictures are wider than the pieces that rows are divided into.
TEST(Film, AlphaEqualsBruteForceInLargerPictures)
{
  for (unsigned int seed = 400; seed < 410 && !HasFailure(); ++seed)
  {
    RandomScene random = makeRandomScene(seed);
    random.width = 133;
    random.height = 41;
    const FilmRequest request = withAlpha(1 + static_cast<int>(seed % 3), seed / 3 % 2 == 0);
    const FilmPicture expected = makeByBruteForce(random, request);
    onAllTargets(
      [&]()
      {
        EXPECT_TRUE(makePicture(random, request, whole(random), Settings()) == expected)
          << "seed " << seed;
      });
  }
}

TEST(Film, PartsWithAlphaEqualThoseOfTheWhole)
{
  for (unsigned int seed = 200; seed < 240; ++seed)
  {
    const RandomScene random = makeSmallScene(seed);
    const FilmRequest request = withAlpha(1 + static_cast<int>(seed % 4), seed / 4 % 2 == 0);
    expectPartEqualToTheWhole(random, request, seed);
  }
}

// The background has no effect on a picture with alpha.
TEST(Film, PicturesWithAlphaHaveNoBackground)
{
  for (unsigned int seed = 0; seed < 30; ++seed)
  {
    RandomScene random = makeSmallScene(seed);
    const FilmRequest request = withAlpha(1 + static_cast<int>(seed % 3), seed % 2 == 0);
    random.scene.background = random.scene.backgroundTop = Vec3(0.0);
    const FilmPicture expected = makePicture(random, request, whole(random), Settings());
    const std::vector<float> grey(6, 0.5f);
    random.scene.background = { 1.0, 2.0, 3.0 };
    random.scene.backgroundTop = { 0.5, 0.25, 5.0 };
    random.scene.backgroundImage = { { grey.data(), AttributeType::Float, 1, false }, 3, 2 };
    EXPECT_TRUE(makePicture(random, request, whole(random), Settings()) == expected) << seed;
    EXPECT_TRUE(makeByBruteForce(random, request) == expected) << seed;
  }
}

// Without surfaces, the picture is black and transparent, and no zero is negative.
TEST(Film, PicturesWithoutSurfacesAreTransparentBlack)
{
  RandomScene random;
  random.width = 45;
  random.height = 7;
  for (const int samples : { 1, 3 })
  {
    const FilmPicture floats =
      makePicture(random, withAlpha(samples, false), whole(random), Settings());
    const std::vector<float> zeros(4u * 45 * 7, 0.0f);
    EXPECT_EQ(std::memcmp(floats.floats.data(), zeros.data(), zeros.size() * sizeof(float)), 0);
    EXPECT_EQ(makePicture(random, withAlpha(samples, true), whole(random), Settings()).bytes,
      std::vector<unsigned char>(4u * 45 * 7, 0));
  }
}

// Composited over a background, the picture with alpha equals the opaque picture up to rounding.
TEST(Film, CompositingGivesTheOpaquePicture)
{
  for (unsigned int seed = 0; seed < 40; ++seed)
  {
    RandomScene random = makeSmallScene(seed);
    random.scene.backgroundTop = random.scene.background;
    FilmRequest request = withAlpha(1 + static_cast<int>(seed % 5), false);
    const FilmPicture picture = makePicture(random, request, whole(random), Settings());
    request.hasAlpha = false;
    const FilmPicture opaque = makePicture(random, request, whole(random), Settings());
    for (int k = 0; k < 3 * random.width * random.height; ++k)
    {
      const double alpha = picture.floats[4 * (k / 3) + 3];
      const double composed = picture.floats[4 * (k / 3) + k % 3] * alpha +
        (1.0 - alpha) * random.scene.background[k % 3];
      EXPECT_NEAR(composed, opaque.floats[k], 3e-7 * (1.0 + std::fabs(composed))) << seed;
    }
  }
}
