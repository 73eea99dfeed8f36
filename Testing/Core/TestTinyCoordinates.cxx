// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Coordinates so small that their products underflow. Rounding then moves the depth of a hit out of
// the range of its triangle's corners, in front of surfaces that are nearer.
#include "InstructionSets.h"
#include "VisibleTriangles.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

using namespace lambent;

namespace
{
constexpr int side = 31; // odd, so that the rays of the middle column have x = 0

/// Many large layers, so that most are dropped before they are cast, and behind them two needles in
/// the middle column, as thin as the smallest number.
struct Needles
{
  std::vector<double> points;
  std::vector<std::int32_t> corners;
  Scene scene;

  Needles(double layerDepth, bool parallel)
  {
    for (int layer = 0; layer < 300; ++layer)
    {
      const double z = -layerDepth - 1e-4 * layer;
      this->points.insert(this->points.end(), { -9.0, -9.0, z, 9.0, -9.0, z, 0.0, 9.0, z });
    }
    constexpr double thin = std::numeric_limits<double>::denorm_min(), z = -1.45;
    for (const double x : { thin, 0.0 })
    {
      this->points.insert(this->points.end(), { 0.0, -0.9, z, thin, -0.5, z, x, 0.9, z });
    }
    this->corners.resize(this->points.size() / 3);
    std::iota(this->corners.begin(), this->corners.end(), 0);
    Surface surface;
    surface.points = { this->points.data(), true, this->corners.size() };
    surface.corners = { this->corners.data(), false, this->corners.size() };
    this->scene.surfaces.push_back(surface);
    this->scene.camera.position = Vec3(0.0);
    this->scene.camera.focalPoint = { 0.0, 0.0, -1.0 };
    this->scene.camera.parallel = parallel;
    this->scene.camera.parallelScale = 0.5;
  }
};
}

TEST(TinyCoordinates, AreDrawnAsDefinedInEveryInstructionSet)
{
  for (const bool parallel : { false, true })
  {
    for (int step = 0; step < 20; ++step)
    {
      const double layerDepth = 1.0 + 0.01 * step;
      const Needles needles(layerDepth, parallel);
      const std::vector<std::uint32_t> expected =
        visibleTriangles(needles.scene, side, Settings::bruteForce({ 0, side, 0, side }));
      onAllTargets(
        [&]()
        {
          EXPECT_EQ(visibleTriangles(needles.scene, side, Settings()), expected)
            << layerDepth << (parallel ? ", parallel" : ", perspective");
        });
    }
  }
}
