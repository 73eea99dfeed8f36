// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Changes of a scene that must not change the picture, or must change it in a known way, to the
// last bit. No brute force is involved, so this also tests the definition itself.
#include "RandomNumbers.h"
#include "RandomScenes.h"
#include "Render.h"
#include "ThreadedParallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace lambent;

namespace
{
constexpr unsigned int sceneCount = 200;

std::vector<float> picture(const RandomScene& random, const Settings& settings = Settings())
{
  std::vector<float> floats(3u * random.width * random.height, -1.0f);
  Image image;
  image.width = random.width;
  image.height = random.height;
  image.part = { 0, random.width, 0, random.height };
  image.floats = floats.data();
  EXPECT_EQ(
    render(random.scene, image, ThreadedParallel(2), nullptr, settings).outcome, Outcome::Done);
  return floats;
}

bool sameBits(const std::vector<float>& a, const std::vector<float>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

std::string describe(unsigned int seed, const RandomScene& random)
{
  return "seed " + std::to_string(seed) + ": " + random.name;
}

/// Calls change(x, y, z) with the coordinates of each point.
template <typename Change>
void changePoints(RandomScene& random, Change&& change)
{
  for (auto& mesh : random.meshes)
  {
    for (std::size_t k = 0; k < mesh->doublePoints.size(); k += 3)
    {
      change(&mesh->doublePoints[k]);
      change(&mesh->floatPoints[k]);
    }
  }
}

/// The scene scaled by a factor, seen from a distance scaled likewise.
RandomScene scaled(unsigned int seed, double factor)
{
  RandomScene random = makeRandomScene(seed);
  changePoints(random,
    [factor](auto* p)
    {
      std::transform(
        p, p + 3, p, [factor](auto c) { return static_cast<decltype(c)>(c * factor); });
    });
  Camera& camera = random.scene.camera;
  camera.position = camera.position * factor;
  camera.focalPoint = camera.focalPoint * factor;
  camera.parallelScale *= factor;
  for (Light& light : random.scene.lights)
  {
    light.position = light.position * factor;
    light.direction = light.direction * factor;
    light.attenuation.y /= factor;
    light.attenuation.z /= factor * factor;
  }
  return random;
}

Vec3 flipped(const Vec3& v)
{
  return { -v.x, v.y, v.z };
}

/// The scene in a mirror. Front faces become back faces, and the normals are mirrored with them.
RandomScene mirrored(RandomScene random)
{
  changePoints(random, [](auto* p) { p[0] = -p[0]; });
  for (auto& mesh : random.meshes)
  {
    for (std::size_t k = 0; k < mesh->normals.size(); k += 3)
    {
      mesh->normals[k + 1] = -mesh->normals[k + 1];
      mesh->normals[k + 2] = -mesh->normals[k + 2];
    }
  }
  Scene& scene = random.scene;
  for (Surface& surface : scene.surfaces)
  {
    std::swap(surface.appearance.cullFront, surface.appearance.cullBack);
  }
  for (Light& light : scene.lights)
  {
    light.position = flipped(light.position);
    light.direction = flipped(light.direction);
  }
  scene.camera.position = flipped(scene.camera.position);
  scene.camera.focalPoint = flipped(scene.camera.focalPoint);
  scene.camera.viewUp = flipped(scene.camera.viewUp);
  return random;
}

std::vector<float> flippedPicture(const std::vector<float>& floats, int width)
{
  std::vector<float> result(floats.size());
  for (std::size_t pixel = 0; pixel < floats.size() / 3; ++pixel)
  {
    const std::size_t column = pixel % width;
    const std::size_t other = pixel - column + (width - 1 - column);
    std::copy_n(&floats[3 * other], 3, &result[3 * pixel]);
  }
  return result;
}
}

// No length is built in, and scaling by a power of two rounds nothing.
TEST(Properties, ScalingByAPowerOfTwoChangesNothing)
{
  for (unsigned int seed = 0; seed < sceneCount; ++seed)
  {
    const RandomScene random = makeRandomScene(seed);
    const std::vector<float> expected = picture(random);
    for (int exponent : { -30, -3, 1, 17, 40 })
    {
      EXPECT_TRUE(sameBits(expected, picture(scaled(seed, std::ldexp(1.0, exponent)))))
        << describe(seed, random) << ", times 2^" << exponent;
    }
  }
}

TEST(Properties, SwappingInputsChangesNothing)
{
  int swapped = 0;
  for (unsigned int seed = 0; seed < sceneCount; ++seed)
  {
    RandomScene random = makeRandomScene(seed);
    const bool hasTies = random.name == "coplanar" || random.name == "grid on rays" ||
      random.name == "through the eye"; // coincident faces, of which the first is seen
    if (random.scene.surfaces.size() < 2 || hasTies)
    {
      continue;
    }
    const std::vector<float> expected = picture(random);
    std::reverse(random.scene.surfaces.begin(), random.scene.surfaces.end());
    EXPECT_TRUE(sameBits(expected, picture(random))) << describe(seed, random);
    ++swapped;
  }
  EXPECT_GT(swapped, 50);
}

TEST(Properties, MirroredScenesGiveMirroredPictures)
{
  for (unsigned int seed = 0; seed < sceneCount; ++seed)
  {
    RandomScene random = makeRandomScene(seed);
    random.scene.twoSidedLighting = true;
    random.scene.camera.windowCenter[0] = 0.0; // rays symmetric about the centre
    const std::vector<float> there = picture(random);
    const std::vector<float> here = picture(mirrored(std::move(random)));
    const int width = makeRandomScene(seed).width;
    EXPECT_TRUE(sameBits(here, flippedPicture(there, width))) << "seed " << seed;
  }
}

TEST(Properties, ALightOfIntensity0ChangesNothing)
{
  for (unsigned int seed = 0; seed < sceneCount; ++seed)
  {
    RandomScene random = makeRandomScene(seed);
    const std::vector<float> expected = picture(random);
    Light dark;
    dark.positional = seed % 2 == 0;
    dark.position = random.scene.camera.position;
    dark.coneAngle = seed % 4 < 2 ? 90.0 : 20.0;
    dark.color = Vec3(0.0);
    std::vector<Light>& lights = random.scene.lights;
    lights.insert(lights.begin() + static_cast<int>(seed % (lights.size() + 1)), dark);
    EXPECT_TRUE(sameBits(expected, picture(random))) << describe(seed, random);
  }
}

TEST(Properties, CullingDropsNothingVisible)
{
  for (unsigned int seed = 0; seed < sceneCount; ++seed)
  {
    const RandomScene random = makeRandomScene(seed);
    Settings all;
    all.culling = false;
    EXPECT_TRUE(sameBits(picture(random), picture(random, all))) << describe(seed, random);
  }
}

namespace
{
/// Scenes with one unlit surface. Rays and points have few digits, so nothing is ever rounded.
struct ExactScene
{
  RandomScene random;

  ExactScene(bool parallel, const std::vector<Vec3>& points)
  {
    this->random.width = this->random.height = 64;
    Camera& camera = this->random.scene.camera;
    camera.position = { 0.0, 0.0, 32.0 };
    camera.viewAngle = 90.0;
    camera.parallel = parallel;
    camera.parallelScale = 16.0;
    this->random.meshes.push_back(std::make_unique<RandomScene::MeshData>());
    RandomScene::MeshData& mesh = *this->random.meshes.back();
    for (const Vec3& p : points)
    {
      mesh.doublePoints.insert(mesh.doublePoints.end(), { p.x, p.y, p.z });
      mesh.corners64.push_back(static_cast<std::int64_t>(mesh.corners64.size()));
    }
    Surface surface;
    surface.points = { mesh.doublePoints.data(), true, points.size() };
    surface.corners = { mesh.corners64.data(), true, points.size() };
    surface.appearance.shading = Shading::Unlit;
    this->random.scene.surfaces.push_back(surface);
  }
};

/// The triangle, cut `times` times along a line from a corner to a point on the opposite edge.
void cut(RandomNumbers& random, const Vec3& a, const Vec3& b, const Vec3& c, int times,
  std::vector<Vec3>& pieces)
{
  if (times == 0)
  {
    pieces.insert(pieces.end(), { a, b, c });
    return;
  }
  const Vec3 between = b + (c - b) * (0.25 * (1 + random.below(3)));
  cut(random, c, a, between, times - 1, pieces);
  cut(random, between, a, b, times - 1, pieces);
}
}

TEST(Properties, SplittingATriangleKeepsItsCoverage)
{
  RandomNumbers random(5);
  for (int trial = 0; trial < 200; ++trial)
  {
    Vec3 corners[3];
    for (Vec3& p : corners)
    {
      p = Vec3(random.below(65) - 32, random.below(65) - 32, random.below(24));
    }
    std::vector<Vec3> pieces;
    cut(random, corners[0], corners[1], corners[2], 4, pieces);
    for (bool parallel : { false, true })
    {
      const std::vector<float> whole =
        picture(ExactScene(parallel, { corners, corners + 3 }).random);
      EXPECT_TRUE(sameBits(whole, picture(ExactScene(parallel, pieces).random)))
        << "trial " << trial << (parallel ? ", parallel" : "");
    }
  }
}
