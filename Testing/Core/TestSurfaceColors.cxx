// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours from data at points and cells. TrianglePoints::at() follows the formulas; instruction
// sets, threads, tiles and parts must not change a bit.
#include "BruteForceChecks.h"
#include "RandomAttributes.h"
#include "RandomColors.h"
#include "ThreadedParallel.h"
#include "TrianglePoints.h"

using namespace lambent;

namespace
{
/// One triangle before the eye, with an array of colours or numbers.
struct ColoredTriangle
{
  const float points[9] = { -1, -1, -4, 2, -1, -5, 0, 3, -3 };
  const std::int32_t corners[3] = { 2, 0, 1 };
  const unsigned char entries[12] = { 10, 20, 30, 40, 50, 60, 70, 80, 90, 100, 110, 120 };
  const std::int64_t cell = 1;
  const ColorTable table{ this->entries, 3, 0.0, 3.0, false };
  ColorArray colors;
  std::vector<Surface> surfaces;

  explicit ColoredTriangle(AttributeSpan values)
    : surfaces(1)
  {
    this->colors.values = values;
    Surface& surface = this->surfaces[0];
    surface.points = { this->points, false, 3 };
    surface.corners = { this->corners, false, 3 };
    surface.cells = &this->cell;
    surface.colors = &this->colors;
    surface.appearance.diffuse = 0.75;
    surface.appearance.ambient = 0.125;
    surface.appearance.diffuseColor = Vec3(0.9);
    surface.appearance.ambientColor = Vec3(0.8);
  }

  /// The point that a ray near the middle of the triangle hits.
  SurfacePoint point() const
  {
    const CameraFrame frame(Camera(), 9, 9);
    const SceneMesh mesh(this->surfaces);
    const FrameMesh inFrame(mesh, frame);
    return TrianglePoints(inFrame, true).at(0, 0.03, 0.05);
  }
};

void expectColor(const SurfacePoint& point, const Vec3& color)
{
  EXPECT_EQ(point.color.diffuse, color * 0.75);
  EXPECT_EQ(point.color.ambient, color * 0.125);
}

/// Values at the corners of the triangle, interpolated.
Vec3 interpolated(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& weights)
{
  return (a * weights.x + b * weights.y) + c * weights.z;
}

struct Subject
{
  RandomScene random;
  RandomAttributes attributes;
  RandomColors colors;
  FilmRequest request;

  Subject(unsigned int seed, int samples)
    : Subject(makeSmallScene(seed), seed, samples)
  {
  }
  Subject(RandomScene scene, unsigned int seed, int samples)
    : random(std::move(scene))
    , attributes(random, seed)
    , colors(random.scene, seed)
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

TEST(SurfaceColors, OfPointsAreInterpolated)
{
  const unsigned char bytes[9] = { 0, 100, 200, 255, 3, 5, 7, 9, 11 };
  const ColoredTriangle colored({ bytes, AttributeType::UInt8, 3, false });
  const SurfacePoint point = colored.point();
  const auto color = [&](int k)
  { return Vec3(bytes[3 * k] / 255.0, bytes[3 * k + 1] / 255.0, bytes[3 * k + 2] / 255.0); };
  expectColor(point, interpolated(color(2), color(0), color(1), point.weights));
}

TEST(SurfaceColors, MayBeNumbersOfAnyType)
{
  const double values[12] = { 0.5, 1.5, -2, 9, 0.1, 0.2, 0.3, 9, 1, 2, 3, 9 };
  const ColoredTriangle colored({ values, AttributeType::Double, 4, false });
  const SurfacePoint point = colored.point();
  const auto color = [&](int k)
  { return Vec3(values[4 * k], values[4 * k + 1], values[4 * k + 2]); };
  expectColor(point, interpolated(color(2), color(0), color(1), point.weights));
}

TEST(SurfaceColors, AreGreyWithOneOrTwoComponents)
{
  const float values[3] = { 0.25f, 0.5f, 1.0f };
  const ColoredTriangle colored({ values, AttributeType::Float, 1, false });
  const SurfacePoint point = colored.point();
  expectColor(point, interpolated(Vec3(1.0), Vec3(0.25), Vec3(0.5), point.weights));
}

TEST(SurfaceColors, OfCellsAreConstant)
{
  const unsigned char bytes[6] = { 1, 2, 3, 40, 50, 60 };
  const ColoredTriangle colored({ bytes, AttributeType::UInt8, 3, true });
  expectColor(colored.point(), { 40 / 255.0, 50 / 255.0, 60 / 255.0 }); // of cell 1
}

TEST(SurfaceColors, OfATableAreMappedFirst)
{
  const float values[6] = { 9, 0.5f, 9, 1.5f, 9, 2.5f };
  ColoredTriangle colored({ values, AttributeType::Float, 2, false });
  colored.colors.table = &colored.table;
  colored.colors.component = 1;
  const SurfacePoint point = colored.point();
  expectColor(point,
    interpolated(
      colored.table.color(2.5), colored.table.color(0.5), colored.table.color(1.5), point.weights));
}

TEST(SurfaceColors, OfATableMayBeMappedLast)
{
  const float values[3] = { 0.5f, 1.5f, 2.75f };
  ColoredTriangle colored({ values, AttributeType::Float, 1, false });
  colored.colors.table = &colored.table;
  colored.colors.isMappedLast = true;
  const SurfacePoint point = colored.point();
  const double number = (2.75 * point.weights.x + 0.5 * point.weights.y) + 1.5 * point.weights.z;
  expectColor(point, colored.table.color(number));
  EXPECT_NE(colored.table.color(number), colored.table.color(0.5)); // it is not that of a corner
}

TEST(SurfaceColors, OfVectorsAreThoseOfTheirLengths)
{
  const float values[9] = { 1, 2, 2, 0, 0, 0, 0, 3, 4 };
  ColoredTriangle colored({ values, AttributeType::Float, 3, false });
  colored.colors.component = ColorArray::magnitude;
  EXPECT_EQ(colored.colors.number(0), 3.0);
  EXPECT_EQ(colored.colors.number(2), 5.0);
}

TEST(SurfaceColors, EqualBruteForceInEveryInstructionSet)
{
  for (unsigned int seed = 0; seed < 80 && !HasFailure(); ++seed)
  {
    const Subject subject(seed, 1 + static_cast<int>(seed % 3));
    Settings settings;
    settings.tileShift = static_cast<int>(seed % 7);
    expectOnAllTargets(subject.random, subject.request,
      makeByBruteForce(subject.random, subject.request), describe(seed, subject.random), settings,
      ThreadedParallel(1 + static_cast<int>(seed % 3)));
  }
}

TEST(SurfaceColors, EqualBruteForceInLargerPictures)
{
  for (unsigned int seed = 700; seed < 712 && !HasFailure(); ++seed)
  {
    const Subject subject(makeLargerScene(seed), seed, 1);
    expectOnAllTargets(subject.random, subject.request,
      makeByBruteForce(subject.random, subject.request), describe(seed, subject.random));
  }
}

TEST(SurfaceColors, PartsEqualThoseOfTheWhole)
{
  for (unsigned int seed = 900; seed < 930; ++seed)
  {
    const Subject subject(seed, 1 + static_cast<int>(seed % 3));
    expectPartEqualToTheWhole(subject.random, subject.request, seed);
  }
}
