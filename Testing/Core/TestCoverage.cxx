// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Coverage treats a sample as certain only if it is right, also where rays pass edges as closely as
// float can resolve.
#include "Coverage.h"
#include "InstructionSets.h"
#include "RandomNumbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

using namespace lambent;

namespace
{
// A large image, since errors grow with the numbers of columns and rows.
constexpr int width = 4000, height = 3000;

struct View
{
  CameraFrame frame;
  PointLattice lattice;

  explicit View(const Camera& camera)
    : frame(camera, width, height)
    , lattice(this->frame, { 0, width, 0, height })
  {
  }

  /// The point at a depth that appears at a column and a row between the samples.
  Vec3 at(double column, double row, double depth) const
  {
    const double x = ((column + 0.5) - this->frame.centerX) * this->frame.pixel;
    const double y = ((row + 0.5) - this->frame.centerY) * this->frame.pixel;
    return this->frame.eye + this->frame.fromEye(x, y, depth);
  }

  bool isHit(const Vec3 (&corners)[3], int i, int j) const
  {
    Hit hit;
    return intersect(this->frame.toFrame(corners[0]), this->frame.toFrame(corners[1]),
      this->frame.toFrame(corners[2]), this->frame.x(i), this->frame.y(j), hit);
  }
};

/// A triangle that covers a few samples, with an edge that passes one of them at a tiny distance.
void makeTriangle(const View& view, RandomNumbers& random, Vec3 (&corners)[3])
{
  const double column = width - 60 + random.below(50), row = height - 60 + random.below(50);
  const double angle = random.within(0.0, 6.3);
  const double along[2] = { std::cos(angle), std::sin(angle) };
  const double distance = random.within(-1.0, 1.0) * std::ldexp(1.0, -10 - random.below(14));
  const double places[3][2] = { { random.within(0.3, 2.0), distance },
    { -random.within(0.3, 2.0), distance }, { random.within(-1.0, 1.0), random.within(0.3, 2.0) } };
  for (int k = 0; k < 3; ++k)
  {
    const double* const p = places[k];
    corners[k] = view.at(column + p[0] * along[0] - p[1] * along[1],
      row + p[0] * along[1] + p[1] * along[0], random.within(2.0, 3.0));
  }
}

/// Makes a batch of the triangle if its box is exact; otherwise returns false.
bool fill(const View& view, const Vec3 (&corners)[3], CoverageBatch& batch)
{
  LatticePosition positions[3];
  for (int k = 0; k < 3; ++k)
  {
    positions[k] = view.lattice.locate(corners[k]);
    for (int axis = 0; axis < 3; ++axis)
    {
      batch.points[3 * k + axis][0] = corners[k][axis];
    }
  }
  const Window box = view.lattice.samplesBetween(positions[0], positions[1], positions[2]);
  batch.count = 1;
  batch.triangles[0] = 0;
  batch.width = box.width();
  batch.height = box.height();
  batch.i[0] = box.i0;
  batch.j[0] = box.j0;
  return !box.empty() && view.lattice.isExact(positions[0], positions[1], positions[2]);
}

using Samples = std::set<std::pair<int, int>>;

Samples samplesOf(const CoveredSample* samples, int count)
{
  Samples all;
  for (int k = 0; k < count; ++k)
  {
    all.emplace(samples[k].i(), samples[k].j());
  }
  return all;
}

/// Returns the number of samples that float arithmetic was certain of.
int compare(const View& view, RandomNumbers& random)
{
  Vec3 corners[3];
  makeTriangle(view, random, corners);
  CoverageBatch batch{};
  if (!fill(view, corners, batch))
  {
    return 0;
  }
  CoveredSamples covered;
  findCoverage(batch, view.lattice, covered);
  const Samples certain = samplesOf(covered.certainSamples, covered.certain);
  const Samples uncertain = samplesOf(covered.uncertainSamples, covered.uncertain);
  for (int j = 0; j < batch.height; ++j)
  {
    for (int i = 0; i < batch.width; ++i)
    {
      if (uncertain.count({ i, j }) == 0)
      {
        EXPECT_EQ(certain.count({ i, j }) == 1, view.isHit(corners, batch.i[0] + i, batch.j[0] + j))
          << batch.i[0] + i << ", " << batch.j[0] + j;
      }
    }
  }
  return batch.width * batch.height - covered.uncertain;
}
}

TEST(Coverage, IsCertainOnlyWhereItIsRight)
{
  onAllTargets(
    []()
    {
      for (bool parallel : { false, true })
      {
        Camera camera;
        camera.position = { 0.3, -0.2, 1.0 };
        camera.parallel = parallel;
        const View view(camera);
        RandomNumbers random(7);
        int certain = 0;
        for (int k = 0; k < 10000; ++k)
        {
          certain += compare(view, random);
        }
        EXPECT_GT(certain, 20000);
      }
    });
}
