// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Layers so close that floats can hardly tell, or cannot tell, which one is in front.
#include "InstructionSets.h"
#include "VisibleTriangles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace lambent;

namespace
{
constexpr int side = 40;

/// Two layers of triangles a few pixels large that face the viewer.
struct Layers
{
  std::vector<double> points;
  std::vector<std::int32_t> corners;
  Scene scene;

  Layers(double depth, double otherDepth, double size, bool parallel)
  {
    this->scene.camera.position = Vec3(0.0);
    this->scene.camera.focalPoint = { 0.0, 0.0, -1.0 };
    this->scene.camera.parallel = parallel;
    for (const double d : { depth, otherDepth })
    {
      const double step = size * (parallel ? 1.0 : 0.25 * d);
      for (int k = -12; k < 12; ++k)
      {
        for (int l = -12; l < 12; ++l)
        {
          const double x = k * step, y = l * step;
          this->points.insert(
            this->points.end(), { x, y, -d, x + 1.9 * step, y, -d, x, y + 1.9 * step, -d });
        }
      }
    }
    this->corners.resize(this->points.size() / 3);
    std::iota(this->corners.begin(), this->corners.end(), 0);
    Surface surface;
    surface.points = { this->points.data(), true, this->corners.size() };
    surface.corners = { this->corners.data(), false, this->corners.size() };
    this->scene.surfaces.push_back(surface);
  }
};
}

TEST(NearLayers, AreDistinguishedInEveryInstructionSet)
{
  onAllTargets(
    []()
    {
      for (int k = -20; k <= 20; ++k)
      {
        for (const double size : { 0.05, 0.2, 0.9 })
        {
          const double depth = 1.0 + 0.07 * (k + 20);
          const Layers layers(depth, depth * (1.0 + std::ldexp(k, -24)), size, k % 3 == 0);
          EXPECT_EQ(visibleTriangles(layers.scene, side, Settings()),
            visibleTriangles(layers.scene, side, Settings::bruteForce({ 0, side, 0, side })))
            << k << ", " << size;
        }
      }
    });
}
