// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Layers so close that floats can hardly decide, or cannot decide, which one is in front, and so
// many layers that most are dropped before they are cast.
#include "InstructionSets.h"
#include "RandomNumbers.h"
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
    this->addSurface();
  }

protected:
  Layers() = default;

  void addSurface()
  {
    this->corners.resize(this->points.size() / 3);
    std::iota(this->corners.begin(), this->corners.end(), 0);
    Surface surface;
    surface.points = { this->points.data(), true, this->corners.size() };
    surface.corners = { this->corners.data(), false, this->corners.size() };
    this->scene.surfaces.push_back(surface);
  }
};

/// Large triangles at random depths. Each covers most of the picture. Some are steep: they have the
/// nearest corners, but lie behind all others within the picture.
struct ManyLayers : Layers
{
  ManyLayers(unsigned seed, double spread, double slope, bool parallel)
  {
    RandomNumbers random(seed);
    this->scene.camera.position = Vec3(0.0);
    this->scene.camera.focalPoint = { 0.0, 0.0, -1.0 };
    this->scene.camera.parallel = parallel;
    this->scene.camera.parallelScale = 0.5;
    for (int layer = 0; layer < 300; ++layer)
    {
      const bool isSteep = layer % 7 == 0;
      const double depth = isSteep ? 8.0 : random.within(2.0, 2.0 + spread);
      const double side = layer % 2 == 0 ? 1.0 : -1.0;
      this->points.insert(this->points.end(), { -2.0 * side, -6.0, isSteep ? -1.5 : -depth });
      for (const double y : { 0.0, 6.0 })
      {
        this->points.insert(this->points.end(),
          { (y > 0.0 ? -2.0 : 6.0) * side, y, -depth - slope * random.within(-1.0, 1.0) });
      }
    }
    this->addSurface();
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

TEST(ManyLayers, ShowTheNearestInEveryInstructionSet)
{
  onAllTargets(
    []()
    {
      for (unsigned seed = 0; seed < 12; ++seed)
      {
        for (const double slope : { 0.0, 1e-6, 0.01, 1.5 })
        {
          const double spread = seed % 3 == 0 ? 1e-6 : 1.0;
          const ManyLayers layers(seed, spread, slope, seed % 2 == 0);
          EXPECT_EQ(visibleTriangles(layers.scene, side, Settings()),
            visibleTriangles(layers.scene, side, Settings::bruteForce({ 0, side, 0, side })))
            << seed << ", " << slope;
        }
      }
    });
}
