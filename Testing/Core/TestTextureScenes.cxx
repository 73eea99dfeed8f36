// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Textures on surfaces of random scenes: brute force equals the fast way to the last bit, and a
// pixel is the lit colour times the texture's.
#include "FilmPicture.h"
#include "InstructionSets.h"
#include "LightModel.h"
#include "RandomAttributes.h"
#include "RandomColors.h"
#include "RandomSpheres.h"
#include "RandomTextures.h"
#include "SurfacePoints.h"
#include "ThreadedParallel.h"

using namespace lambent;

namespace
{
constexpr unsigned int sceneCount = 300;

/// The texture's colour where a ray hits a triangle, with the arithmetic of this test.
TextureColor textureOf(const Surface& surface, std::size_t triangle, const Vec3& weights)
{
  const AttributeSpan& coordinates = surface.texture->coordinates;
  double at[2] = { 0.0, 0.0 };
  for (int k = 0; k < std::min(coordinates.components, 2); ++k)
  {
    const auto corner = [&](int c) { return coordinates.at(surface.corners[3 * triangle + c], k); };
    at[k] = (corner(0) * weights.x + corner(1) * weights.y) + corner(2) * weights.z;
  }
  return surface.texture->texture.sample(at[0], at[1]);
}
}

TEST(TextureScenes, TheLitColourIsMultiplied)
{
  std::size_t textured = 0;
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    RandomScene random = makeRandomScene(seed);
    const RandomTextures textures(random.scene, seed);
    const SceneMesh mesh(random.scene.surfaces);
    const CameraFrame frame(random.scene.camera, random.width, random.height);
    const FrameMesh inFrame(mesh, frame);
    const SurfacePoints points(inFrame, random.scene.twoSidedLighting);
    const LightModel light(random.scene, frame.eye);
    const FilmPicture picture = makeByBruteForce(random, {});
    for (int pixel = 0; pixel < random.width * random.height; ++pixel)
    {
      const std::uint32_t hit = picture.primitives[pixel];
      if (hit == noPrimitive)
      {
        continue;
      }
      const SceneMesh::Part& part = mesh.partOf(hit);
      const SurfacePoint point =
        points.at(hit, frame.x(pixel % random.width), frame.y(pixel / random.width));
      const TextureColor factor = part.surface->texture
        ? textureOf(*part.surface, hit - part.firstPrimitive, point.weights)
        : TextureColor();
      textured += part.surface->texture ? 1 : 0;
      ASSERT_EQ(point.texture.alpha, 1.0); // as none is used
      const Vec3 expected = light.color(point) * factor.color;
      for (int channel = 0; channel < 3; ++channel)
      {
        const float found = picture.floats[3 * pixel + channel];
        ASSERT_TRUE(found == static_cast<float>(expected[channel]) ||
          (std::isnan(found) && std::isnan(expected[channel])))
          << "seed " << seed << ", pixel " << pixel;
      }
    }
  }
  EXPECT_GT(textured, 5000u);
}

TEST(TextureScenes, BruteForceEqualsAnyInstructionSet)
{
  onAllTargets(
    []()
    {
      for (unsigned int seed = 0; seed < sceneCount; ++seed)
      {
        RandomScene random = makeSmallScene(seed);
        const RandomAttributes attributes(random, seed);
        const RandomColors colors(random.scene, seed);
        const RandomTextures textures(random.scene, seed);
        FilmRequest request;
        request.samples = 1 + static_cast<int>(seed % 3);
        request.hasAlpha = seed % 2 == 0;
        request.isBytes = seed % 7 == 0;
        if (seed % 4 == 0)
        {
          request.passes = attributes.passes;
        }
        EXPECT_TRUE(makePicture(random, request, whole(random), Settings(), ThreadedParallel(2)) ==
          makeByBruteForce(random, request))
          << "seed " << seed;
      }
    });
}

TEST(TextureScenes, SpheresHaveNone)
{
  for (unsigned int seed = 0; seed < 70; ++seed)
  {
    RandomScene random = makeFewRandomSpheres(seed);
    const FilmPicture plain = makePicture(random, {}, whole(random), Settings());
    const RandomTextures textures(random.scene, seed);
    const FilmPicture textured = makePicture(random, {}, whole(random), Settings());
    EXPECT_TRUE(textured == makeByBruteForce(random, {})) << "seed " << seed;
    const SceneMesh mesh(random.scene.surfaces);
    for (std::size_t pixel = 0; pixel < plain.primitives.size(); ++pixel)
    {
      const std::uint32_t hit = plain.primitives[pixel];
      if (hit == noPrimitive || mesh.partOf(hit).kind() == PrimitiveKind::Sphere)
      {
        EXPECT_EQ(
          std::memcmp(&plain.floats[3 * pixel], &textured.floats[3 * pixel], 3 * sizeof(float)), 0);
      }
    }
  }
}
