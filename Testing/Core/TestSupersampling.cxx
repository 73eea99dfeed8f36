// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// A picture with n samples along each axis of a pixel is, by definition, the picture of n times
// its size, averaged. Neither instruction sets nor threads, tiles or parts may change a bit.
#include "AverageKernel.h"
#include "InstructionSets.h"
#include "LightModel.h"
#include "RandomNumbers.h"
#include "RandomScenes.h"
#include "Render.h"
#include "SurfacePoints.h"
#include "ThreadedParallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

using namespace lambent;

namespace
{
struct Picture
{
  std::vector<float> floats;
  std::vector<std::uint32_t> primitives;

  bool operator==(const Picture& other) const
  {
    return this->floats.size() == other.floats.size() &&
      std::memcmp(this->floats.data(), other.floats.data(), this->floats.size() * sizeof(float)) ==
      0 &&
      this->primitives == other.primitives;
  }
};

Picture makePicture(const RandomScene& random, int samples, const Window& part,
  const Settings& settings, const Parallel& parallel = Parallel())
{
  Picture picture;
  picture.floats.assign(3u * part.width() * part.height(), -1.0f);
  picture.primitives.assign(part.width() * part.height(), 0xABABABABu); // not a triangle
  Image image;
  image.width = random.width;
  image.height = random.height;
  image.part = part;
  image.samples = samples;
  image.floats = picture.floats.data();
  image.primitives = picture.primitives.data();
  EXPECT_EQ(render(random.scene, image, parallel, nullptr, settings).outcome, Outcome::Done);
  return picture;
}

Window whole(const RandomScene& random)
{
  return { 0, random.width, 0, random.height };
}

Picture makeByBruteForce(const RandomScene& random, int samples)
{
  return makePicture(random, samples, whole(random),
    Settings::bruteForce({ 0, random.width * samples, 0, random.height * samples }));
}

/// A random scene, small enough for brute force with many samples.
RandomScene makeSmallScene(unsigned int seed)
{
  RandomScene random = makeRandomScene(seed);
  random.width = 1 + static_cast<int>(seed % 23);
  random.height = 1 + static_cast<int>(seed % 17);
  return random;
}

/// The part of a picture inside a window.
Picture cut(const Picture& picture, int width, const Window& part)
{
  Picture result;
  for (int j = part.j0; j < part.j1; ++j)
  {
    for (int i = part.i0; i < part.i1; ++i)
    {
      const float* const pixel = &picture.floats[3 * (j * width + i)];
      result.floats.insert(result.floats.end(), pixel, pixel + 3);
      result.primitives.push_back(picture.primitives[j * width + i]);
    }
  }
  return result;
}
}

// The definition, written as plainly as possible, from the triangles of the larger picture.
TEST(Supersampling, AveragesTheLargerPicture)
{
  for (unsigned int seed = 0; seed < 60 && !HasFailure(); ++seed)
  {
    const RandomScene random = makeSmallScene(seed);
    const int n = 1 + static_cast<int>(seed % 6);
    RandomScene larger = makeSmallScene(seed);
    larger.width *= n;
    larger.height *= n;
    const std::vector<std::uint32_t> seen = makeByBruteForce(larger, 1).primitives;
    const SceneMesh mesh(random.scene.surfaces);
    const CameraFrame frame(random.scene.camera, larger.width, larger.height);
    const FrameMesh inFrame(mesh, frame);
    const SurfacePoints points(inFrame, random.scene.twoSidedLighting);
    const LightModel light(random.scene, frame.eye);
    const Picture picture = makeByBruteForce(random, n);
    for (int pixel = 0; pixel < random.width * random.height; ++pixel)
    {
      const int i0 = n * (pixel % random.width), j0 = n * (pixel / random.width);
      Vec3 sum;
      for (int k = 0; k < n * n; ++k)
      {
        const int i = i0 + k % n, j = j0 + k / n;
        const std::uint32_t triangle = seen[j * larger.width + i];
        const Vec3 background = random.scene.background +
          (random.scene.backgroundTop - random.scene.background) * ((j + 0.5) / larger.height);
        const Vec3 color = triangle == noPrimitive
          ? background
          : light.color(points.at(triangle, frame.x(i), frame.y(j)));
        sum = k == 0 ? color : sum + color;
      }
      for (int channel = 0; channel < 3; ++channel)
      {
        EXPECT_EQ(picture.floats[3 * pixel + channel],
          static_cast<float>(sum[channel] / static_cast<double>(n * n)))
          << "seed " << seed << ", pixel " << pixel << ", " << n << " samples";
      }
      EXPECT_EQ(picture.primitives[pixel], seen[(j0 + n / 2) * larger.width + i0 + n / 2]);
    }
  }
}

TEST(Supersampling, EmptyPartsStoreNothing)
{
  const RandomScene random = makeSmallScene(5);
  for (const Window& part :
    { Window{ 3, 3, 0, 2 }, Window{ 0, 4, 2, 2 }, Window{ 5, 2, 0, 2 }, Window{ 0, 4, 3, -2 } })
  {
    for (int samples : { 1, 2 })
    {
      Image image;
      image.width = random.width;
      image.height = random.height;
      image.part = part;
      image.samples = samples;
      EXPECT_EQ(render(random.scene, image).outcome, Outcome::Done);
    }
  }
}

TEST(Supersampling, EqualsBruteForceInEveryInstructionSet)
{
  for (unsigned int seed = 100; seed < 140 && !HasFailure(); ++seed)
  {
    const RandomScene random = makeSmallScene(seed);
    const int n = 2 + static_cast<int>(seed % 15);
    const Picture expected = makeByBruteForce(random, n);
    onAllTargets(
      [&]()
      {
        Settings settings;
        settings.tileShift = static_cast<int>(seed % 7); // also tiles of a single pixel
        EXPECT_TRUE(makePicture(random, n, whole(random), settings) == expected)
          << "seed " << seed << ", " << n << " samples";
        EXPECT_TRUE(
          makePicture(random, n, whole(random), Settings(), ThreadedParallel(3)) == expected)
          << "seed " << seed << ", " << n << " samples, three workers";
      });
  }
}

TEST(Supersampling, PartsEqualTheWhole)
{
  for (unsigned int seed = 200; seed < 240; ++seed)
  {
    const RandomScene random = makeSmallScene(seed);
    const int n = 2 + static_cast<int>(seed % 4);
    const Window part{ random.width / 3, random.width, random.height / 2, random.height };
    EXPECT_TRUE(makePicture(random, n, part, Settings()) ==
      cut(makePicture(random, n, whole(random), Settings()), random.width, part))
      << "seed " << seed << ", " << n << " samples";
  }
}

// The bins fill up, so tiles must keep their hits from round to round.
TEST(Supersampling, KeepsHitsFromRoundToRound)
{
  Settings settings;
  settings.binPages = 1;
  settings.chunk = 7;
  for (unsigned int seed = 300; seed < 320; ++seed)
  {
    const RandomScene random = makeSmallScene(seed);
    EXPECT_TRUE(makePicture(random, 3, whole(random), settings) == makeByBruteForce(random, 3))
      << "seed " << seed;
  }
}

// Each band is a picture of its own.
TEST(Supersampling, BandsEqualTheWhole)
{
  for (unsigned int seed = 400; seed < 440; ++seed)
  {
    const RandomScene random = makeSmallScene(seed);
    const Window part{ random.width / 4, random.width, random.height / 3, random.height };
    Settings settings;
    settings.mostSamples = 1 + seed % 5 * 9 * part.width(); // up to four rows of pixels
    EXPECT_TRUE(makePicture(random, 3, part, settings) == makePicture(random, 3, part, Settings()))
      << "seed " << seed;
    EXPECT_TRUE(makePicture(random, 1, part, settings) == makePicture(random, 1, part, Settings()))
      << "seed " << seed;
  }
}

// In doubles: floats rarely show the last bit.
TEST(Supersampling, TheKernelAddsInOrderAndDivides)
{
  constexpr int pixels = 37, stride = 16 * pixels, beyond = 16 * 8;
  RandomNumbers random(1);
  std::vector<double> samples(16 * stride + beyond);
  std::generate(samples.begin(), samples.end(), [&]() { return random.within(-1.0, 1.0); });
  onAllTargets(
    [&]()
    {
      for (int n = 1; n <= 16; ++n)
      {
        double averages[pixels + 8];
        averageSamples(samples.data(), stride, n, pixels, averages);
        for (int pixel = 0; pixel < pixels; ++pixel)
        {
          double sum = samples[pixel * n];
          for (int k = 1; k < n * n; ++k)
          {
            sum += samples[k / n * stride + pixel * n + k % n];
          }
          ASSERT_EQ(averages[pixel], sum / (n * n)) << n << " samples, pixel " << pixel;
        }
      }
    });
}
