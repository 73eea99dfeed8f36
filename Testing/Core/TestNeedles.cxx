// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles so thin that their edge functions round to zero along their line. In an ordinary view
// no ray beyond their ends is tested. If pixels are so small that points cannot be located between
// them, every ray is, and the kernel itself must decide where a needle ends.
#include "InstructionSets.h"
#include "RandomNumbers.h"
#include "VisibleTriangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace lambent;

namespace
{
constexpr int side = 31;
const double scale = std::ldexp(1.0, -210); // of the view; too small for PointLattice to be precise

/// Needles from the centre towards the rays around it, which end shortly before these rays.
std::vector<double> makeNeedles(int count, const CameraFrame& frame)
{
  RandomNumbers random(5);
  std::vector<double> points;
  for (int k = 0; k < count; ++k)
  {
    const double length = random.within(0.3, 0.95);
    const double x = length * frame.x(side / 2 + random.below(5) - 2);
    const double y = length * frame.y(side / 2 + random.below(5) - 2);
    points.insert(points.end(), { 0.0, 0.0, 0.0, x, y, 0.0, x, std::nextafter(y, 1.0), 0.0 });
  }
  return points;
}
}

TEST(Needles, EndAtTheirTipsInEveryInstructionSet)
{
  constexpr int count = 400;
  Scene scene;
  scene.camera.parallel = true;
  scene.camera.parallelScale = scale;
  const std::vector<double> points = makeNeedles(count, CameraFrame(scene.camera, side, side));
  std::vector<std::int32_t> corners(3 * count);
  std::iota(corners.begin(), corners.end(), 0);
  Surface surface;
  surface.points = { points.data(), true, corners.size() };
  surface.corners = { corners.data(), false, corners.size() };
  scene.surfaces.push_back(surface);

  const std::vector<std::uint32_t> expected =
    visibleTriangles(scene, side, Settings::bruteForce({ 0, side, 0, side }));
  EXPECT_NE(expected[side * (side / 2) + side / 2], noPrimitive); // all needles begin here
  EXPECT_LT(std::count_if(expected.begin(), expected.end(),
              [](std::uint32_t triangle) { return triangle != noPrimitive; }),
    10); // rays beyond the ends lie on the needles' lines
  onAllTargets([&]() { EXPECT_EQ(visibleTriangles(scene, side, Settings()), expected); });
}
