// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Edges and highlights: instruction sets, threads, tiles and parts must not change a bit.
#include "BruteForceChecks.h"
#include "RandomAttributes.h"
#include "RandomColors.h"
#include "RandomStyles.h"
#include "ThreadedParallel.h"

using namespace lambent;

namespace
{
struct Subject
{
  RandomScene random;
  RandomAttributes attributes;
  RandomColors colors;
  RandomStyles styles;
  FilmRequest request;

  Subject(RandomScene scene, unsigned int seed, int samples)
    : random(std::move(scene))
    , attributes(random, seed)
    , colors(random.scene, seed)
    , styles(random.scene, seed)
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
}

TEST(SurfaceStyles, EqualBruteForceInEveryInstructionSet)
{
  for (unsigned int seed = 0; seed < 80 && !HasFailure(); ++seed)
  {
    const Subject subject(makeSmallScene(seed), seed, 1 + static_cast<int>(seed % 3));
    Settings settings;
    settings.tileShift = static_cast<int>(seed % 7);
    expectOnAllTargets(subject.random, subject.request,
      makeByBruteForce(subject.random, subject.request), describe(seed, subject.random), settings,
      ThreadedParallel(1 + static_cast<int>(seed % 3)));
  }
}

TEST(SurfaceStyles, EqualBruteForceInLargerPictures)
{
  for (unsigned int seed = 700; seed < 712 && !HasFailure(); ++seed)
  {
    const Subject subject(makeLargerScene(seed), seed, 1);
    expectOnAllTargets(subject.random, subject.request,
      makeByBruteForce(subject.random, subject.request), describe(seed, subject.random));
  }
}

TEST(SurfaceStyles, PartsEqualThoseOfTheWhole)
{
  for (unsigned int seed = 900; seed < 930; ++seed)
  {
    const Subject subject(makeSmallScene(seed), seed, 1 + static_cast<int>(seed % 3));
    expectPartEqualToTheWhole(subject.random, subject.request, seed);
  }
}

// Samples of both are shaded together.
TEST(SurfaceStyles, EdgesOfTheSecondOfTwoSurfacesAreDrawn)
{
  const float points[18] = { -1, -1, 0, -1, 1, 0, 0, -1, 0, 0, -1, 0, 1, -1, 0, 1, 1, 0 };
  const std::int32_t corners[6] = { 0, 1, 2, 3, 4, 5 };
  RandomScene random;
  random.width = random.height = 32;
  for (int k = 0; k < 2; ++k)
  {
    Surface surface;
    surface.points = { points, false, 6 };
    surface.corners = { corners + 3 * k, false, 3 };
    surface.appearance.shading = Shading::Unlit;
    surface.appearance.edges.areVisible = k == 1;
    random.scene.surfaces.push_back(surface);
  }
  random.scene.camera.parallel = true; // 16 pixels per unit
  const FilmPicture picture = makePicture(random, {}, whole(random), Settings());
  const auto at = [&](std::size_t i, std::size_t j) { return picture.floats[3 * (32 * j + i)]; };
  EXPECT_EQ(at(4, 0), 1.0f);
  EXPECT_EQ(at(28, 0), 0.0f);
  EXPECT_EQ(at(28, 4), 1.0f);
  EXPECT_TRUE(picture == makeByBruteForce(random, {}));
}

TEST(SurfaceStyles, AppearancesWithOtherStylesAreNotTheSame)
{
  const Appearance plain;
  const auto expectOther = [&](const auto& change)
  {
    Appearance other;
    EXPECT_TRUE(other.isSameAs(plain));
    change(other);
    EXPECT_FALSE(other.isSameAs(plain));
  };
  expectOther([](Appearance& a) { a.edges.areVisible = true; });
  expectOther([](Appearance& a) { a.edges.width = 2.0; });
  expectOther([](Appearance& a) { a.edges.opacity = 0.5; });
  expectOther([](Appearance& a) { a.edges.color.z = 1.0; });
  expectOther([](Appearance& a) { a.specular.coefficient = 0.5; });
  expectOther([](Appearance& a) { a.specular.color.z = 0.5; });
  expectOther([](Appearance& a) { a.specular.power = 2.0; });
}
