// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Passes show what the middle sample of each pixel sees. Brute force follows the formulas.
// Instruction sets, threads, tiles, parts and rounds must not change a bit.
#include "FilmPicture.h"
#include "InstructionSets.h"
#include "RandomAttributes.h"
#include "ThreadedParallel.h"

#include <limits>

using namespace lambent;

namespace
{
/// A scene with attributes, and a picture that shows all of them.
struct Subject
{
  RandomScene random;
  RandomAttributes attributes;
  FilmRequest request;

  Subject(unsigned int seed, int samples)
    : Subject(makeSmallScene(seed), seed, samples)
  {
  }
  Subject(RandomScene scene, unsigned int seed, int samples)
    : random(std::move(scene))
    , attributes(random, seed)
  {
    this->request.samples = samples;
    this->request.passes = this->attributes.passes;
    this->request.hasAlpha = seed % 3 == 0;
    this->request.isBytes = seed % 2 == 0;
  }
};

/// A triangle of the scene, and where the ray of a sample hits it.
struct Sighting
{
  std::size_t surface;
  std::size_t triangle; ///< of the surface
  double x, y;
  Hit hit;

  Sighting(const RandomScene& random, const CameraFrame& frame, std::size_t number, int i, int j)
    : surface(0)
    , triangle(number)
    , x(frame.x(i))
    , y(frame.y(j))
    , hit{}
  {
    const std::vector<Surface>& surfaces = random.scene.surfaces;
    while (this->triangle >= surfaces[this->surface].triangleCount())
    {
      this->triangle -= surfaces[this->surface++].triangleCount();
    }
    const auto corner = [&](std::size_t k)
    { return frame.toFrame(surfaces[this->surface].points[this->point(random, k)]); };
    EXPECT_TRUE(intersect(corner(0), corner(1), corner(2), this->x, this->y, this->hit));
  }

  std::uint64_t point(const RandomScene& random, std::size_t corner) const
  {
    return random.scene.surfaces[this->surface].corners[3 * this->triangle + corner];
  }
};

/// The normal as the surface has it: the face normal, or the point normals weighted by the edge
/// functions.
Vec3 givenNormal(const RandomScene& random, const Sighting& seen, bool& isReversed)
{
  const Surface& surface = random.scene.surfaces[seen.surface];
  const auto point = [&](std::size_t k) { return surface.points[seen.point(random, k)]; };
  const Vec3 winding = cross(point(1) - point(0), point(2) - point(0));
  if (surface.appearance.shading == Shading::Smooth && surface.pointNormals)
  {
    const auto normal = [&](std::size_t k) { return surface.pointNormals[seen.point(random, k)]; };
    isReversed = dot(winding, (normal(0) + normal(1)) + normal(2)) < 0.0;
    const Vec3 sum = (normal(0) * seen.hit.e0 + normal(1) * seen.hit.e1) + normal(2) * seen.hit.e2;
    return seen.hit.sum < 0.0 ? -sum : sum; // edge functions are negative on the back
  }
  const Vec3 face = surface.cellNormals
    ? surface.cellNormals[static_cast<std::size_t>(surface.cellOf(seen.triangle))]
    : winding;
  isReversed = dot(winding, face) < 0.0;
  return face;
}

Vec3 expectedNormal(const RandomScene& random, const Sighting& seen)
{
  bool isReversed = false;
  const Vec3 normal = givenNormal(random, seen, isReversed);
  const bool isBack = seen.hit.sum < 0.0;
  const bool isAway = random.scene.twoSidedLighting && isBack != isReversed;
  const Vec3 facing = isAway ? -normal : normal;
  const double length =
    std::sqrt((facing.x * facing.x + facing.y * facing.y) + facing.z * facing.z);
  return { facing.x / length, facing.y / length, facing.z / length };
}

Vec3 expectedPosition(const RandomScene& random, const CameraFrame& frame, const Sighting& seen)
{
  const Vec3 across = frame.right * seen.x + frame.up * seen.y;
  return random.scene.camera.position +
    (random.scene.camera.parallel ? across + frame.forward * seen.hit.depth
                                  : (across + frame.forward) * seen.hit.depth);
}

double expectedAttribute(
  const Subject& subject, const Sighting& seen, std::size_t attribute, int component)
{
  const Surface& surface = subject.random.scene.surfaces[seen.surface];
  if (attribute >= surface.attributes.size() ||
    subject.attributes.values[seen.surface][attribute].empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::vector<double>& values = subject.attributes.values[seen.surface][attribute];
  const AttributeSpan& form = surface.attributes[attribute];
  const auto at = [&](std::uint64_t tuple)
  { return values[tuple * static_cast<std::size_t>(form.components) + component]; };
  if (form.isPerCell)
  {
    return at(static_cast<std::uint64_t>(surface.cellOf(seen.triangle)));
  }
  const auto corner = [&](std::size_t k) { return at(seen.point(subject.random, k)); };
  const Hit& hit = seen.hit;
  return (corner(0) * (hit.e0 / hit.sum) + corner(1) * (hit.e1 / hit.sum)) +
    corner(2) * (hit.e2 / hit.sum);
}

double expectedValue(const Subject& subject, const CameraFrame& frame, const Sighting& seen,
  const Pass& pass, int component)
{
  switch (pass.content)
  {
    case PassContent::Depth:
      return seen.hit.depth;
    case PassContent::Normal:
      return expectedNormal(subject.random, seen)[component];
    case PassContent::Position:
      return expectedPosition(subject.random, frame, seen)[component];
    case PassContent::Attribute:
      break;
  }
  return expectedAttribute(subject, seen, pass.attribute, component);
}

/// Compares the bits of a component. All NaN of a type have the same bits.
void expectStored(const FilmPicture& picture, const Pass& form, std::size_t pass, int pixel,
  int component, double expected, const std::string& where)
{
  const double stored = picture.value(form, pass, static_cast<std::size_t>(pixel), component);
  if (!std::isnan(expected))
  {
    EXPECT_EQ(stored, form.isDouble ? expected : static_cast<double>(static_cast<float>(expected)))
      << where;
    return;
  }
  const std::size_t size = form.isDouble ? sizeof(double) : sizeof(float);
  const double wide = std::numeric_limits<double>::quiet_NaN();
  const float narrow = std::numeric_limits<float>::quiet_NaN();
  const std::size_t k = static_cast<std::size_t>(pixel) * form.components + component;
  EXPECT_EQ(std::memcmp(picture.passes[pass].data() + k * size,
              form.isDouble ? static_cast<const void*>(&wide) : &narrow, size),
    0)
    << where << ": " << stored;
}
}

// The definition, written as plainly as possible, from the triangles of a larger picture with one
// sample per pixel.
TEST(PassPainting, ShowsWhatTheMiddleSampleSees)
{
  std::size_t hits = 0, nothings = 0;
  for (unsigned int seed = 0; seed < 120 && !HasFailure(); ++seed)
  {
    const int n = 1 + static_cast<int>(seed % 5);
    const Subject subject(seed, n);
    const RandomScene& random = subject.random;
    RandomScene larger = makeSmallScene(seed);
    larger.width *= n;
    larger.height *= n;
    const std::vector<std::uint32_t> seen = makeByBruteForce(larger, FilmRequest()).primitives;
    const CameraFrame frame(random.scene.camera, larger.width, larger.height);
    const FilmPicture picture = makeByBruteForce(random, subject.request);
    for (int pixel = 0; pixel < random.width * random.height; ++pixel)
    {
      const int i = n * (pixel % random.width) + n / 2, j = n * (pixel / random.width) + n / 2;
      const std::uint32_t triangle = seen[static_cast<std::size_t>(j) * larger.width + i];
      (triangle == noPrimitive ? nothings : hits) += 1;
      for (std::size_t k = 0; k < subject.request.passes.size(); ++k)
      {
        const Pass& pass = subject.request.passes[k];
        for (int component = 0; component < pass.components; ++component)
        {
          const double expected = triangle == noPrimitive
            ? std::numeric_limits<double>::quiet_NaN()
            : expectedValue(
                subject, frame, Sighting(random, frame, triangle, i, j), pass, component);
          expectStored(picture, pass, k, pixel, component, expected,
            "seed " + std::to_string(seed) + ", pixel " + std::to_string(pixel) + ", pass " +
              std::to_string(k) + ", component " + std::to_string(component));
        }
      }
    }
  }
  EXPECT_GT(hits, 3000u); // both occur often
  EXPECT_GT(nothings, 3000u);
}

TEST(PassPainting, EqualsBruteForceInEveryInstructionSet)
{
  for (unsigned int seed = 100; seed < 150 && !HasFailure(); ++seed)
  {
    const int n = 1 + static_cast<int>(seed % 16);
    const Subject subject(seed, n);
    const FilmPicture expected = makeByBruteForce(subject.random, subject.request);
    onAllTargets(
      [&]()
      {
        const auto picture = [&](int tileShift, int workers)
        {
          Settings settings;
          settings.tileShift = tileShift;
          return makePicture(subject.random, subject.request, whole(subject.random), settings,
            ThreadedParallel(workers));
        };
        EXPECT_TRUE(picture(static_cast<int>(seed % 7), 1) == expected) << "seed " << seed;
        EXPECT_TRUE(picture(5, 3) == expected) << "seed " << seed << ", three workers";
      });
  }
}

// The pictures are wide enough for several pieces in a row of a tile, and for tiles without
// triangles.
TEST(PassPainting, EqualsBruteForceInLargerPictures)
{
  for (unsigned int seed = 400; seed < 410 && !HasFailure(); ++seed)
  {
    RandomScene random = makeRandomScene(seed);
    random.width = 161;
    random.height = 75;
    const Subject subject(std::move(random), seed, 1 + static_cast<int>(seed % 2));
    const FilmPicture expected = makeByBruteForce(subject.random, subject.request);
    onAllTargets(
      [&]()
      {
        for (const int tileShift : { 3, 5, 7 })
        {
          Settings settings;
          settings.tileShift = tileShift;
          EXPECT_TRUE(makePicture(subject.random, subject.request, whole(subject.random),
                        settings) == expected)
            << "seed " << seed << ", tile shift " << tileShift;
        }
      });
  }
}

TEST(PassPainting, PartsEqualThoseOfTheWhole)
{
  for (unsigned int seed = 200; seed < 240; ++seed)
  {
    const Subject subject(seed, 1 + static_cast<int>(seed % 4));
    expectPartEqualToTheWhole(subject.random, subject.request, seed);
  }
}

// Colours as bytes and as floats, ids, and passes of both types.
TEST(PassPainting, BandsEqualTheWhole)
{
  for (unsigned int seed = 0; seed < 30; ++seed)
  {
    const Subject subject(seed, 2 + static_cast<int>(seed % 3));
    Settings settings;
    settings.mostSamples = 1 + seed % 5 * 16 * subject.random.width; // a few rows of pixels
    EXPECT_TRUE(makePicture(subject.random, subject.request, whole(subject.random), settings) ==
      makePicture(subject.random, subject.request, whole(subject.random), Settings()))
      << "seed " << seed;
  }
}

// If the bins fill up, tiles keep their hits from round to round. A round has at least a million
// triangles, so the mesh is repeated to make it large.
TEST(PassPainting, WorksInSeveralRounds)
{
  for (const unsigned int seed : { 303u, 304u })
  {
    RandomScene random = makeRandomScene(seed);
    std::vector<std::int64_t>& corners = random.meshes[0]->corners64;
    const std::vector<std::int64_t> once = corners;
    while (corners.size() / 3 < 1200000)
    {
      corners.insert(corners.end(), once.begin(), once.end());
    }
    random.scene.surfaces[0].corners = { corners.data(), true, corners.size() };
    const Subject subject(std::move(random), seed, 1 + static_cast<int>(seed % 2));
    Settings manyRounds;
    manyRounds.binPages = 1;
    EXPECT_TRUE(makePicture(subject.random, subject.request, whole(subject.random), Settings()) ==
      makePicture(
        subject.random, subject.request, whole(subject.random), manyRounds, ThreadedParallel(2)))
      << "seed " << seed;
  }
}

// Passes do not change the colours.
TEST(PassPainting, ChangesNoColour)
{
  for (unsigned int seed = 500; seed < 530; ++seed)
  {
    const Subject subject(seed, 1 + static_cast<int>(seed % 3));
    FilmRequest plain = subject.request;
    plain.passes.clear();
    const FilmPicture with =
      makePicture(subject.random, subject.request, whole(subject.random), Settings());
    FilmPicture without = makePicture(subject.random, plain, whole(subject.random), Settings());
    without.passes = with.passes;
    EXPECT_TRUE(with == without) << "seed " << seed;
  }
}
