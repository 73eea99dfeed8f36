// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Brute force defines each picture: every triangle is tested against every ray. Tiles, chunks of
// triangles and threads must not change a bit of it, or the triangle that a pixel shows.
#include "LightModel.h"
#include "RandomScenes.h"
#include "Render.h"
#include "SurfacePoints.h"
#include "ThreadedParallel.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace lambent;

namespace
{
constexpr unsigned int sceneCount = 400;

struct Picture
{
  std::vector<float> floats;
  std::vector<std::uint32_t> primitives;
  Outcome outcome = Outcome::Done;
};

Picture makePicture(const RandomScene& random, const Window& part, const Settings& settings,
  const Parallel& parallel = Parallel())
{
  Picture picture;
  picture.floats.assign(3u * part.width() * part.height(), -1.0f);
  picture.primitives.assign(part.width() * part.height(), 0xABABABABu); // not a triangle
  Image image;
  image.width = random.width;
  image.height = random.height;
  image.part = part;
  image.floats = picture.floats.data();
  image.primitives = picture.primitives.data();
  picture.outcome = render(random.scene, image, parallel, nullptr, settings).outcome;
  return picture;
}

Window whole(const RandomScene& random)
{
  return { 0, random.width, 0, random.height };
}

/// The number of channels that differ in a bit, plus the number of pixels with another triangle.
std::size_t differences(const Picture& a, const Picture& b)
{
  std::size_t count = a.floats.size() == b.floats.size() ? 0 : 1;
  for (std::size_t k = 0; count == 0 && k < a.floats.size(); ++k)
  {
    count += std::memcmp(&a.floats[k], &b.floats[k], sizeof(float)) != 0;
  }
  for (std::size_t k = 0; count == 0 && k < a.primitives.size(); ++k)
  {
    count += a.primitives[k] != b.primitives[k];
  }
  return count;
}

std::string describe(unsigned int seed, const RandomScene& random)
{
  return "seed " + std::to_string(seed) + ": " + random.name + ", " + std::to_string(random.width) +
    " x " + std::to_string(random.height);
}

Settings smallTiles(int shift)
{
  Settings settings;
  settings.tileShift = shift;
  settings.chunk = 7;
  return settings;
}
}

// The definition, written as plainly as possible: two loops and intersect().
TEST(BruteForce, TestsEachTriangleAgainstEachRay)
{
  std::size_t hits = 0;
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    const RandomScene random = makeRandomScene(seed);
    const SceneMesh mesh(random.scene.surfaces);
    const CameraFrame frame(random.scene.camera, random.width, random.height);
    const FrameMesh inFrame(mesh, frame);
    const SurfacePoints points(inFrame, random.scene.twoSidedLighting);
    const LightModel light(random.scene, frame.eye);
    const Picture picture = makePicture(random, whole(random), Settings::bruteForce(whole(random)));
    for (int j = 0; j < random.height; ++j)
    {
      for (int i = 0; i < random.width; ++i)
      {
        std::uint32_t nearest = noPrimitive, number = 0;
        double depth = std::numeric_limits<double>::infinity();
        for (const Surface& surface : random.scene.surfaces)
        {
          for (std::size_t t = 0; t < surface.triangleCount(); ++t, ++number)
          {
            FramePoint p[3];
            for (int k = 0; k < 3; ++k)
            {
              p[k] = frame.toFrame(surface.points[surface.corners[3 * t + k]]);
            }
            Hit hit;
            if (intersect(p[0], p[1], p[2], frame.x(i), frame.y(j), hit) && hit.depth < depth &&
              !(surface.appearance.cullFront && hit.sum > 0.0) &&
              !(surface.appearance.cullBack && hit.sum < 0.0))
            {
              depth = hit.depth;
              nearest = number;
            }
          }
        }
        const Vec3 background = random.scene.background +
          (random.scene.backgroundTop - random.scene.background) * ((j + 0.5) / random.height);
        const Vec3 expected = nearest == noPrimitive
          ? background
          : light.color(points.at(nearest, frame.x(i), frame.y(j)));
        hits += nearest != noPrimitive;
        ASSERT_EQ(picture.primitives[j * random.width + i], nearest) << describe(seed, random);
        for (int channel = 0; channel < 3; ++channel)
        {
          ASSERT_EQ(picture.floats[3 * (j * random.width + i) + channel],
            static_cast<float>(expected[channel]))
            << describe(seed, random) << ", pixel " << i << ", " << j;
        }
      }
    }
  }
  EXPECT_GT(hits, 10000u); // guards against scenes that are hardly hit
}

TEST(BruteForce, EqualsTiles)
{
  for (unsigned int seed = 0; seed < sceneCount; ++seed)
  {
    const RandomScene random = makeRandomScene(seed);
    const Picture reference =
      makePicture(random, whole(random), Settings::bruteForce(whole(random)));
    for (int shift : { 0, 2, 3, 5 })
    {
      EXPECT_EQ(differences(reference, makePicture(random, whole(random), smallTiles(shift))), 0u)
        << describe(seed, random) << ", cells of " << (1 << shift);
    }
  }
}

TEST(BruteForce, EqualsAnyNumberOfThreads)
{
  for (unsigned int seed = 0; seed < sceneCount; ++seed)
  {
    const RandomScene random = makeRandomScene(seed);
    const Picture reference =
      makePicture(random, whole(random), Settings::bruteForce(whole(random)));
    for (int threads : { 1, 2, 3, 8 })
    {
      const Picture picture =
        makePicture(random, whole(random), smallTiles(4), ThreadedParallel(threads));
      EXPECT_EQ(differences(reference, picture), 0u)
        << describe(seed, random) << ", " << threads << " threads";
    }
  }
}

TEST(BruteForce, EqualsAnyInstructionSet)
{
  const std::string usual = vectorTargetInUse();
  const std::vector<std::string> targets = vectorTargets();
  EXPECT_GE(targets.size(), 2u);
  EXPECT_EQ(targets.front(), "plain");
  for (const std::string& target : targets)
  {
    ASSERT_TRUE(useVectorTarget(target));
    ASSERT_EQ(vectorTargetInUse(), target);
    for (unsigned int seed = 0; seed < sceneCount; ++seed)
    {
      const RandomScene random = makeRandomScene(seed);
      const Picture reference =
        makePicture(random, whole(random), Settings::bruteForce(whole(random)));
      EXPECT_EQ(differences(reference, makePicture(random, whole(random), Settings())), 0u)
        << describe(seed, random) << ", " << target;
    }
  }
  EXPECT_FALSE(useVectorTarget("none of these"));
  EXPECT_TRUE(useVectorTarget(usual));
}

// So few bins that the tiles are processed after every batch of triangles. A batch has a million
// triangles, so the mesh is repeated until it is large.
TEST(BruteForce, EqualsSeveralRounds)
{
  for (unsigned int seed : { 1u, 4u })
  {
    RandomScene random = makeRandomScene(seed);
    RandomScene::MeshData& data = *random.meshes[0];
    Surface& surface = random.scene.surfaces[0];
    const std::vector<std::int64_t> corners = data.corners64;
    while (data.corners64.size() / 3 < 2500000)
    {
      data.corners64.insert(data.corners64.end(), corners.begin(), corners.end());
    }
    Settings oneRound, manyRounds;
    manyRounds.binPages = 1;
    surface.corners = { data.corners64.data(), true, data.corners64.size() };
    EXPECT_EQ(differences(makePicture(random, whole(random), oneRound),
                makePicture(random, whole(random), manyRounds, ThreadedParallel(2))),
      0u)
      << describe(seed, random);
  }
}

// So many tiles that they are processed in several batches, with a checkpoint after each.
TEST(BruteForce, EqualsSeveralBatchesOfTiles)
{
  for (unsigned int seed : { 0u, 5u })
  {
    RandomScene random = makeRandomScene(seed);
    random.width = 150;
    random.height = 120;
    const Picture reference =
      makePicture(random, whole(random), Settings::bruteForce(whole(random)));
    EXPECT_EQ(differences(reference, makePicture(random, whole(random), smallTiles(0))), 0u)
      << describe(seed, random);
  }
}

// The columns need more than 15 bits, so points are located between groups of samples.
TEST(BruteForce, EqualsAVeryWideImage)
{
  std::size_t hits = 0;
  for (unsigned int seed = 0; seed < randomSceneKinds; ++seed)
  {
    RandomScene random = makeRandomScene(seed);
    random.width = 40000;
    random.height = 2;
    random.scene.camera.horizontalViewAngle = true;
    const Picture reference =
      makePicture(random, whole(random), Settings::bruteForce(whole(random)));
    hits += random.width * random.height -
      std::count(reference.primitives.begin(), reference.primitives.end(), noPrimitive);
    EXPECT_EQ(differences(reference, makePicture(random, whole(random), Settings())), 0u)
      << describe(seed, random);
  }
  EXPECT_GT(hits, 10000u);
}

// Tiles with many triangles are split among the workers.
TEST(BruteForce, EqualsSplitTiles)
{
  for (unsigned int seed : { 1u, 3u, 11u })
  {
    RandomScene random = makeRandomScene(seed);
    RandomScene::MeshData& data = *random.meshes[0];
    const std::vector<std::int64_t> corners = data.corners64;
    while (data.corners64.size() / 3 < 200000)
    {
      data.corners64.insert(data.corners64.end(), corners.begin(), corners.end());
    }
    random.scene.surfaces[0].corners = { data.corners64.data(), true, data.corners64.size() };
    Settings settings;
    settings.tileShift = 7;
    const Picture alone = makePicture(random, whole(random), settings);
    for (int threads : { 2, 3, 8 })
    {
      EXPECT_EQ(
        differences(alone, makePicture(random, whole(random), settings, ThreadedParallel(threads))),
        0u)
        << describe(seed, random) << ", " << threads << " threads";
    }
  }
}

TEST(BruteForce, EqualsThePartsOfAnImage)
{
  for (unsigned int seed = 0; seed < sceneCount; seed += 3)
  {
    const RandomScene random = makeRandomScene(seed);
    const Picture reference =
      makePicture(random, whole(random), Settings::bruteForce(whole(random)));
    const Window part{ random.width / 3, random.width - random.width / 4, random.height / 4,
      random.height - random.height / 5 };
    const Picture picture = makePicture(random, part, Settings());
    for (int j = part.j0; j < part.j1; ++j)
    {
      const std::size_t row = 3u * (j - part.j0) * part.width();
      ASSERT_EQ(
        std::memcmp(&picture.floats[row], &reference.floats[3u * (j * random.width + part.i0)],
          3u * part.width() * sizeof(float)),
        0)
        << describe(seed, random) << ", row " << j;
      for (int i = part.i0; i < part.i1; ++i)
      {
        ASSERT_EQ(picture.primitives[(j - part.j0) * part.width() + i - part.i0],
          reference.primitives[j * random.width + i])
          << describe(seed, random) << ", " << i << ", " << j;
      }
    }
  }
}
