// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Transparent surfaces. A plain loop over all primitives and rays follows the formulas; instruction
// sets, threads, tiles, parts, rounds and the order of the surfaces must not change a bit.
#include "BruteForceChecks.h"
#include "RandomAttributes.h"
#include "RandomColors.h"
#include "RandomNumbers.h"
#include "RandomSpheres.h"
#include "RandomTextures.h"
#include "ThreadedParallel.h"

#include <algorithm>

using namespace lambent;

namespace
{
/// Gives most surfaces an opacity, and uses the alpha of some colours.
class RandomOpacities
{
public:
  RandomOpacities(Scene& scene, unsigned int seed)
  {
    RandomNumbers random(seed + 77);
    for (Surface& surface : scene.surfaces)
    {
      const double opacities[] = { 1.0, 0.0, 0.25, random.within(0.0, 1.0), 1.0 };
      surface.appearance.opacity = opacities[random.below(5)];
      if (surface.colors && surface.kind() == PrimitiveKind::Sphere &&
        surface.colors->values.isPerCell)
      {
        surface.colors = nullptr; // spheres have no cells
      }
      if (surface.colors && random.below(3) > 0)
      {
        this->Colors.push_back(std::make_unique<ColorArray>(*surface.colors));
        this->Colors.back()->hasAlpha = true;
        surface.colors = this->Colors.back().get();
      }
    }
  }

private:
  std::vector<std::unique_ptr<ColorArray>> Colors;
};

struct Subject
{
  RandomScene random;
  RandomAttributes attributes;
  RandomColors colors;
  RandomTextures textures;
  RandomOpacities opacities;
  FilmRequest request;

  Subject(RandomScene scene, unsigned int seed, int samples)
    : random(std::move(scene))
    , attributes(random, seed)
    , colors(random.scene, seed)
    , textures(random.scene, seed, seed % 5 < 2)
    , opacities(random.scene, seed)
  {
    this->request.samples = samples;
    this->request.hasAlpha = seed % 3 == 0;
    this->request.isBytes = seed % 2 == 0;
    if (seed % 4 == 1)
    {
      this->request.passes = this->attributes.passes;
    }
  }
};

/// Triangles for even seeds, spheres and triangles for odd ones.
Subject subjectOf(unsigned int seed, int samples)
{
  return { seed % 2 == 0 ? makeSmallScene(seed) : makeFewRandomSpheres(seed), seed, samples };
}

/// A square that faces the eye, which is at the origin and looks down the z axis.
struct Pane
{
  const float points[12];
  static constexpr std::int32_t corners[6] = { 0, 1, 2, 0, 2, 3 };

  explicit Pane(float z)
    : points{ -9, -9, z, 9, -9, z, 9, 9, z, -9, 9, z }
  {
  }
  Surface surface(const Vec3& color, double opacity) const
  {
    Surface result;
    result.points = { this->points, false, 4 };
    result.corners = { corners, false, 6 };
    result.appearance.shading = Shading::Unlit;
    result.appearance.diffuseColor = color;
    result.appearance.opacity = opacity;
    return result;
  }
};

/// The one pixel of a scene, with four channels if it has alpha.
std::vector<float> pixelOf(std::vector<Surface> surfaces, bool hasAlpha = false)
{
  RandomScene random;
  random.width = random.height = 1;
  random.scene.surfaces = std::move(surfaces);
  random.scene.camera.position = Vec3(0.0);
  random.scene.camera.focalPoint = Vec3(0.0, 0.0, -1.0);
  random.scene.background = random.scene.backgroundTop = Vec3(0.0, 0.0, 1.0);
  FilmRequest request;
  request.hasAlpha = hasAlpha;
  return makePicture(random, request, whole(random), Settings()).floats;
}
}

TEST(Transparency, CompositesFromTheNearestToTheFarthest)
{
  const Pane near(-2), far(-3);
  const Surface red = near.surface({ 1, 0, 0 }, 0.25), green = far.surface({ 0, 1, 0 }, 0.5);
  const std::vector<float> expected = { 0.25f, 0.375f, 0.375f };
  EXPECT_EQ(pixelOf({ red, green }), expected);
  EXPECT_EQ(pixelOf({ green, red }), expected);
  const std::vector<float> straight = { 0.25f / 0.625f, 0.375f / 0.625f, 0.0f, 0.625f };
  EXPECT_EQ(pixelOf({ green, red }, true), straight);
}

TEST(Transparency, AnOpaqueSurfaceEndsTheList)
{
  const Pane near(-2), middle(-3), far(-4);
  const Surface red = near.surface({ 1, 0, 0 }, 0.25), green = middle.surface({ 0, 1, 0 }, 1.0),
                white = far.surface({ 1, 1, 1 }, 0.5);
  EXPECT_EQ(pixelOf({ white, red, green }), (std::vector<float>{ 0.25f, 0.75f, 0.0f }));
}

TEST(Transparency, ASurfaceOfOpacityZeroIsNotThere)
{
  const Pane near(-2), far(-3);
  const Surface ghost = near.surface({ 1, 0, 0 }, 0.0), green = far.surface({ 0, 1, 0 }, 1.0);
  RandomScene random;
  random.width = random.height = 1;
  random.scene.surfaces = { ghost, green };
  random.scene.camera.position = Vec3(0.0);
  random.scene.camera.focalPoint = Vec3(0.0, 0.0, -1.0);
  const FilmPicture picture = makePicture(random, FilmRequest(), whole(random), Settings());
  EXPECT_EQ(picture.floats, (std::vector<float>{ 0.0f, 1.0f, 0.0f }));
  EXPECT_GE(picture.primitives[0], 2u); // of the green pane
}

// Rays pass exactly through edges and corners.
TEST(Transparency, AHitOnASharedEdgeCountsOnce)
{
  constexpr std::int32_t fan[24] = { 0, 1, 8, 1, 2, 8, 2, 3, 8, 3, 4, 8, 4, 5, 8, 5, 6, 8, 6, 7, 8,
    7, 0, 8 }; // around a point
  const float points[27] = { -4, -4, 0, 0, -4, 0, 4, -4, 0, 4, 0, 0, 4, 4, 0, 0, 4, 0, -4, 4, 0, -4,
    0, 0, 0, 0, 0 };
  RandomScene random;
  random.width = random.height = 8;
  random.scene.camera.parallel = true;
  random.scene.camera.parallelScale = 4.0;
  random.scene.camera.position = Vec3(0.5, 0.5, 5.0);
  random.scene.camera.focalPoint = Vec3(0.5, 0.5, 0.0);
  Surface surface;
  surface.points = { points, false, 9 };
  surface.corners = { fan, false, 24 };
  surface.appearance.shading = Shading::Unlit;
  surface.appearance.opacity = 0.5;
  random.scene.surfaces = { surface };
  FilmRequest request;
  request.hasAlpha = true;
  const FilmPicture picture = makePicture(random, request, whole(random), Settings());
  std::size_t covered = 0;
  for (std::size_t pixel = 0; pixel < 64; ++pixel)
  {
    const float alpha = picture.floats[4 * pixel + 3];
    EXPECT_TRUE(alpha == 0.0f || alpha == 0.5f) << "pixel " << pixel;
    covered += alpha == 0.5f ? 1 : 0;
  }
  EXPECT_EQ(covered, 64u); // also those on the right and on the upper edge
}

TEST(Transparency, OfPointsIsInterpolatedAndMultiplied)
{
  const Pane pane(-2);
  const unsigned char bytes[16] = { 255, 255, 255, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255,
    255, 255, 0 }; // alpha 0 on the left, 1 on the right
  ColorArray colors;
  colors.values = { bytes, AttributeType::UInt8, 4, false };
  colors.hasAlpha = true;
  Surface surface = pane.surface(Vec3(1.0), 0.5);
  surface.colors = &colors;
  EXPECT_EQ(pixelOf({ surface }), (std::vector<float>{ 0.25f, 0.25f, 1.0f }));
}

TEST(Transparency, BothSidesOfASphereAreSeen)
{
  const float center[3] = { 0, 0, -4 };
  Surface sphere;
  sphere.points = { center, false, 1 };
  sphere.radius = 1.0;
  sphere.appearance.shading = Shading::Unlit;
  sphere.appearance.opacity = 0.5;
  EXPECT_EQ(sphere.primitiveCount(), 2u);
  EXPECT_EQ(sphere.cellOf(1), 0);
  EXPECT_EQ(pixelOf({ sphere }, true)[3], 0.75f);
  sphere.appearance.cullFront = true;
  EXPECT_EQ(pixelOf({ sphere }, true)[3], 0.5f);
}

// The definition, written as plainly as possible.
TEST(Transparency, CompositesAllHitsOfEachRay)
{
  std::size_t deep = 0;
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    Subject subject = subjectOf(seed, 1);
    subject.request = FilmRequest();
    subject.request.hasAlpha = true;
    const RandomScene& random = subject.random;
    const SceneMesh mesh(random.scene.surfaces);
    const CameraFrame frame(random.scene.camera, random.width, random.height);
    const FrameMesh inFrame(mesh, frame);
    const SurfacePoints points(inFrame, random.scene.twoSidedLighting);
    const LightModel light(random.scene, frame.eye);
    const FilmPicture picture = makeByBruteForce(random, subject.request);
    for (int pixel = 0; pixel < random.width * random.height; ++pixel)
    {
      const double x = frame.x(pixel % random.width), y = frame.y(pixel / random.width);
      std::vector<std::pair<double, std::uint32_t>> hits;
      for (std::uint32_t k = 0; k < mesh.primitiveCount(); ++k)
      {
        double depth;
        if (inFrame.hits(k, x, y, depth))
        {
          hits.emplace_back(depth, k);
        }
      }
      std::sort(hits.begin(), hits.end());
      Vec3 color(0.0);
      double left = 1.0;
      for (const auto& [depth, primitive] : hits)
      {
        const SurfacePoint point = points.at(primitive, x, y);
        const double opacity = point.opacity();
        color = left > 0.0 && opacity > 0.0
          ? color + light.color(point) * point.texture.color * (left * opacity)
          : color;
        left *= 1.0 - opacity;
      }
      deep += hits.size() > 2 && left > 0.0 ? 1 : 0;
      const float* const stored = picture.floats.data() + 4 * pixel;
      const double alpha = 1.0 - left;
      ASSERT_EQ(stored[3], static_cast<float>(alpha)) << "seed " << seed << ", pixel " << pixel;
      for (int channel = 0; alpha > 0.0 && channel < 3; ++channel)
      {
        const float expected = toFloat(color[channel] / alpha);
        ASSERT_EQ(std::memcmp(stored + channel, &expected, sizeof(float)), 0)
          << "seed " << seed << ", pixel " << pixel;
      }
    }
  }
  EXPECT_GT(deep, 100u);
}

TEST(Transparency, EqualsBruteForceInEveryInstructionSet)
{
  for (unsigned int seed = 0; seed < 100 && !HasFailure(); ++seed)
  {
    const Subject subject = subjectOf(seed, 1 + static_cast<int>(seed % 3));
    Settings settings;
    settings.tileShift = static_cast<int>(seed % 7);
    settings.binPages = seed % 5 == 0 ? 1 : settings.binPages; // several rounds
    settings.chunk = seed % 5 == 0 ? 16 : settings.chunk;
    expectOnAllTargets(subject.random, subject.request,
      makeByBruteForce(subject.random, subject.request), describe(seed, subject.random), settings,
      ThreadedParallel(1 + static_cast<int>(seed % 3)));
  }
}

TEST(Transparency, EqualsBruteForceInLargerPictures)
{
  for (unsigned int seed = 300; seed < 312 && !HasFailure(); ++seed)
  {
    const Subject subject(makeLargerScene(seed), seed, 1);
    expectOnAllTargets(subject.random, subject.request,
      makeByBruteForce(subject.random, subject.request), describe(seed, subject.random), Settings(),
      ThreadedParallel(3));
  }
}

TEST(Transparency, PartsEqualThoseOfTheWhole)
{
  for (unsigned int seed = 900; seed < 930; ++seed)
  {
    const Subject subject = subjectOf(seed, 1 + static_cast<int>(seed % 3));
    expectPartEqualToTheWhole(subject.random, subject.request, seed);
  }
}

TEST(Transparency, ManyLayersAreSortedByDepth)
{
  constexpr int count = 300;
  std::vector<std::unique_ptr<Pane>> panes;
  std::vector<Surface> surfaces;
  for (int k = 0; k < count; ++k)
  {
    const int place = k * 7 % count; // neither near to far nor far to near
    panes.push_back(std::make_unique<Pane>(-2.0f - 0.001f * static_cast<float>(place)));
    surfaces.push_back(panes.back()->surface(Vec3(place / double(count)), 1.0 / 64));
  }
  double color = 0.0, left = 1.0;
  for (int place = 0; place < count; ++place)
  {
    color += place / double(count) * (left * (1.0 / 64));
    left *= 1.0 - 1.0 / 64;
  }
  EXPECT_EQ(pixelOf(surfaces)[0], static_cast<float>(color));
}
