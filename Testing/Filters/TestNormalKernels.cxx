// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The kernels of the normals give the bits of the plain code that defines them, with every
// instruction set; and the angles are accurate.

#include "CheckKernel.h"
#include "CornerAngles.h"
#include "PointNormals.h"

#include "../Core/InstructionSets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace lambent;

namespace
{
constexpr Weighting allWeightings[] = { Weighting::Uniform, Weighting::Area, Weighting::Angle,
  Weighting::Max };

// Several workers that run one after the other.
class InTurn : public Parallel
{
public:
  int workers() const override { return 3; }
  void run(const std::function<void(int)>& body) const override
  {
    for (int worker = 0; worker < this->workers(); ++worker)
    {
      body(worker);
    }
  }
};

template <typename Coordinate, typename Id>
struct Triangles
{
  std::vector<Coordinate> points;
  std::vector<Id> offsets, corners;

  Faces faces() const
  {
    Faces result;
    result.points = { this->points.data(), sizeof(Coordinate) == 8, this->points.size() / 3 };
    result.cells = { { this->offsets.data(), sizeof(Id) == 8, this->offsets.size() },
      { this->corners.data(), sizeof(Id) == 8, this->corners.size() } };
    const CheckedCells checked = checkCells(result.cells, result.points.size, Parallel());
    EXPECT_FALSE(checked.defect);
    result.blocks = checked.blocks;
    return result;
  }
};

// Triangles of all shapes: between points close to each other and far apart; in small whole
// coordinates (right angles, equal edges, no area); needles; enormous and tiny ones; and some with
// infinite or NaN coordinates.
template <typename Coordinate, typename Id>
Triangles<Coordinate, Id> makeTriangles(unsigned int seed, int pointCount, int triangleCount)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Triangles<Coordinate, Id> mesh;
  const auto largest = static_cast<double>(std::numeric_limits<Coordinate>::max());
  for (int i = 0; i < pointCount; ++i)
  {
    const unsigned int kind = random() % 64;
    for (int axis = 0; axis < 3; ++axis)
    {
      double x = kind < 32 ? uniform(random) : std::floor(3.0 * uniform(random));
      x *= kind == 0 ? std::sqrt(largest) : (kind == 1 ? 1.0 / std::sqrt(largest) : 1.0);
      x *= kind == 2 ? largest : (kind == 3 && axis == 1 ? 1e-9 : 1.0);
      x = kind == 4 && axis == 2 && seed % 2 ? std::numeric_limits<double>::quiet_NaN() : x;
      mesh.points.push_back(static_cast<Coordinate>(x));
    }
  }
  mesh.offsets.push_back(0);
  for (int i = 0; i < triangleCount; ++i)
  {
    const bool isNear = random() % 16 != 0;
    const int around = static_cast<int>(random() % static_cast<unsigned int>(pointCount));
    for (int corner = 0; corner < 3; ++corner)
    {
      const int step = static_cast<int>(random() % (isNear ? 20u : 1000000u));
      mesh.corners.push_back(static_cast<Id>((around + step) % pointCount));
    }
    mesh.offsets.push_back(static_cast<Id>(mesh.corners.size()));
  }
  return mesh;
}

std::vector<float> normalsOf(const Faces& faces, Weighting weighting, float sign)
{
  std::vector<float> normals(3 * faces.points.size, -7.0f);
  computePointNormals(faces, weighting, sign, InTurn(), normals.data());
  return normals;
}

template <typename Coordinate, typename Id>
void comparePlainWithKernels()
{
  for (unsigned int seed = 1; seed <= 12; ++seed)
  {
    const auto mesh =
      makeTriangles<Coordinate, Id>(seed, 1 + 211 * seed, static_cast<int>(37 * seed * seed));
    const Faces faces = mesh.faces();
    for (const Weighting weighting : allWeightings)
    {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", weighting " +
        std::to_string(static_cast<int>(weighting)));
      const float sign = seed % 3 == 0 ? -1.0f : 1.0f;
      const std::string usual = vectorTargetInUse();
      ASSERT_TRUE(useVectorTarget("plain"));
      const std::vector<float> expected = normalsOf(faces, weighting, sign);
      ASSERT_TRUE(useVectorTarget(usual));
      onAllTargets(
        [&]
        {
          const std::vector<float> normals = normalsOf(faces, weighting, sign);
          EXPECT_EQ(
            std::memcmp(normals.data(), expected.data(), sizeof(float) * normals.size()), 0);
        });
      const auto usable =
        std::count_if(expected.begin(), expected.end(), [](float value) { return value != 0.0f; });
      EXPECT_GT(usable, static_cast<std::ptrdiff_t>(expected.size() / 8)) << "nothing to compare";
    }
  }
}

double ulps(double value, long double expected)
{
  const double near = std::fabs(static_cast<double>(expected));
  const double ulp = std::nextafter(near, std::numeric_limits<double>::infinity()) - near;
  return static_cast<double>(std::fabs(value - expected)) / ulp;
}
}

TEST(NormalKernels, EqualTheDefinitionFloat32)
{
  comparePlainWithKernels<float, std::int32_t>();
}

TEST(NormalKernels, EqualTheDefinitionFloat64)
{
  comparePlainWithKernels<float, std::int64_t>();
}

TEST(NormalKernels, EqualTheDefinitionDouble32)
{
  comparePlainWithKernels<double, std::int32_t>();
}

TEST(NormalKernels, EqualTheDefinitionDouble64)
{
  comparePlainWithKernels<double, std::int64_t>();
}

TEST(NormalKernels, ChecksFindDefectsAtAnyPosition)
{
  onAllTargets(
    []
    {
      for (std::size_t count = 1; count <= 70; ++count)
      {
        std::vector<std::int64_t> offsets(count + 1), ids(count, 5);
        for (std::size_t i = 0; i <= count; ++i)
        {
          offsets[i] = static_cast<std::int64_t>(3 * i);
        }
        std::vector<double> numbers(count, std::numeric_limits<double>::max());
        ASSERT_TRUE(areFinite(numbers.data(), count));
        ASSERT_TRUE(classifyOffsets(offsets.data(), count).areOfTriangles);
        ASSERT_TRUE(classifyOffsets(offsets.data(), count).areAscending);
        for (std::size_t i = 0; i < count; ++i)
        {
          numbers[i] = i % 2 ? std::numeric_limits<double>::quiet_NaN()
                             : -std::numeric_limits<double>::infinity();
          EXPECT_FALSE(areFinite(numbers.data(), count));
          numbers[i] = 0.0;

          ids[i] = i % 2 ? -(std::int64_t(1) << 40) : std::int64_t(1) << 40;
          const IdRange range = findRange(ids.data(), count);
          EXPECT_EQ(range.first, std::min<std::int64_t>(ids[i], count > 1 ? 5 : ids[i]));
          EXPECT_EQ(range.last, std::max<std::int64_t>(ids[i], count > 1 ? 5 : ids[i]));
          ids[i] = 5;

          offsets[i + 1] += 1; // the next cell has two points
          EXPECT_FALSE(classifyOffsets(offsets.data(), count).areOfTriangles);
          EXPECT_TRUE(classifyOffsets(offsets.data(), count).areAscending);
          offsets[i + 1] -= 5; // this cell has -1 points
          EXPECT_FALSE(classifyOffsets(offsets.data(), count).areAscending);
          offsets[i + 1] += 4;
        }
      }
    });
}

TEST(CornerAngles, AreAccurate)
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  double worst = 0.0, worstOfTriangle = 0.0;
  for (int i = 0; i < 300000; ++i)
  {
    // All magnitudes, so that angles are also close to 0 and to half a turn.
    const double y = std::fabs(uniform(random)) * std::pow(10.0, i % 13 - 6);
    const double x = uniform(random);
    worst = std::max(worst, ulps(angleOf(y, x), std::atan2(static_cast<long double>(y), x)));

    // The triangle (0, 0), (1, 0), (p, y); its area vector has the length y.
    const double p = 2.0 * x;
    const long double longY = y, longP = p;
    const double products[] = { p, 1.0 - p,
      static_cast<double>(longP * longP - longP + longY * longY) };
    const TriangleAngles angles = anglesOf(y, products[0], products[1], products[2]);
    const double found[] = { angles.a, angles.b, angles.c };
    for (int corner = 0; corner < 3; ++corner)
    {
      worstOfTriangle = std::max(worstOfTriangle,
        ulps(found[corner], std::atan2(longY, static_cast<long double>(products[corner]))));
    }
  }
  RecordProperty("worst", std::to_string(worst) + " " + std::to_string(worstOfTriangle));
  EXPECT_LE(worst, 2.0);
  EXPECT_LE(worstOfTriangle, 4.0);
}

TEST(CornerAngles, AreExactForSpecialAngles)
{
  EXPECT_EQ(angleOf(0.0, 1.0), 0.0);
  EXPECT_EQ(angleOf(0.0, 0.0), 0.0);
  EXPECT_EQ(angleOf(0.0, -1.0), piHigh);
  EXPECT_EQ(angleOf(3.0, 0.0), 0.5 * piHigh);
  EXPECT_EQ(angleOf(3.0, 3.0), 0.25 * piHigh);
  EXPECT_EQ(angleOf(3.0, -3.0), 0.75 * piHigh);
  const TriangleAngles half = anglesOf(1.0, 1.0, 0.0, 1.0); // of half a square
  EXPECT_EQ(half.a, 0.25 * piHigh);
  EXPECT_EQ(half.b, 0.5 * piHigh);
  EXPECT_EQ(half.c, 0.25 * piHigh);
  const TriangleAngles huge = anglesOf(1e150, 1e160, 1.0, 1e160);
  EXPECT_EQ(huge.a + huge.b + huge.c, 0.0);
}
