// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief render a small scene once with the core on one thread, for callgrind to count
 *
 *     LambentInstructions NAME     renders the scene of that name
 *     LambentInstructions          prints the names
 *
 * Count only measuredRender(): --toggle-collect=measuredRender.
 */
#include "Render.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace
{
struct SmallScene
{
  std::vector<float> points, normals;
  std::vector<std::int64_t> corners;
  int width = 320, height = 240;

  void add(const std::array<double, 3>& point, const std::array<double, 3>& normal)
  {
    this->points.insert(this->points.end(), point.begin(), point.end());
    this->normals.insert(this->normals.end(), normal.begin(), normal.end());
  }

  void addQuads(std::int64_t first, int n)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const std::int64_t a = first + j * (n + 1) + i;
        this->corners.insert(this->corners.end(), { a, a + 1, a + n + 2, a, a + n + 2, a + n + 1 });
      }
    }
  }

  std::int64_t pointCount() const { return static_cast<std::int64_t>(this->points.size() / 3); }
};

/// Adds a wavy disc-like sheet of 2 n^2 triangles that fills most of the image.
void addSheet(SmallScene& scene, int n, double z)
{
  const std::int64_t first = scene.pointCount();
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x = 2.0 * i / n - 1, y = 2.0 * j / n - 1;
      scene.add({ x, y, z + 0.1 * std::sin(5 * x) * std::cos(4 * y) },
        { -0.5 * std::cos(5 * x) * std::cos(4 * y), 0.4 * std::sin(5 * x) * std::sin(4 * y), 1 });
    }
  }
  scene.addQuads(first, n);
}

SmallScene coarse()
{
  SmallScene scene;
  addSheet(scene, 16, 0);
  return scene;
}

/// Most triangles lie between the rays.
SmallScene fine()
{
  SmallScene scene;
  addSheet(scene, 300, 0);
  return scene;
}

SmallScene layers()
{
  SmallScene scene;
  for (int k : { 5, 11, 2, 8, 0, 14, 7, 3, 12, 1, 9, 15, 4, 10, 6, 13 })
  {
    addSheet(scene, 8, 0.03 * k);
  }
  return scene;
}

SmallScene needles()
{
  SmallScene scene;
  std::mt19937 engine(3);
  const auto random = [&engine]() { return engine() / 2147483648.0 - 1; };
  for (int k = 0; k < 1000; ++k)
  {
    const std::array<double, 3> a{ random(), random(), 0.1 * random() }, b{ random(), random(), 0 };
    const std::int64_t first = scene.pointCount();
    scene.add(a, { 0, 0, 1 });
    scene.add(b, { 0, 0, 1 });
    scene.add({ b[0] + 0.004, b[1] + 0.003, 0 }, { 0, 0, 1 });
    scene.corners.insert(scene.corners.end(), { first, first + 1, first + 2 });
  }
  return scene;
}

const std::map<std::string, SmallScene (*)()> scenes = { { "coarse", coarse }, { "fine", fine },
  { "layers", layers }, { "needles", needles } };

lambent::Scene describe(const SmallScene& small)
{
  lambent::Surface surface;
  surface.points = { small.points.data(), false, small.points.size() / 3 };
  surface.pointNormals = { small.normals.data(), false, small.normals.size() / 3 };
  surface.corners = { small.corners.data(), true, small.corners.size() };
  lambent::Light light;
  light.positional = true;
  light.position = { -2, 3, 4 };
  lambent::Scene scene;
  scene.surfaces.push_back(surface);
  scene.lights.push_back(light);
  scene.camera.position = { 0.3, 0.2, 4 };
  return scene;
}
}

extern "C" __attribute__((noinline)) void measuredRender(
  const lambent::Scene& scene, const lambent::Image& image)
{
  lambent::render(scene, image);
}

int main(int argc, char** argv)
{
  if (argc < 2)
  {
    for (const auto& named : scenes)
    {
      std::cout << named.first << "\n";
    }
    return EXIT_SUCCESS;
  }
  const auto named = scenes.find(argv[1]);
  if (named == scenes.end())
  {
    std::cerr << "error: there is no scene '" << argv[1] << "'\n";
    return EXIT_FAILURE;
  }
  const SmallScene small = named->second();
  const lambent::Scene scene = describe(small);
  std::vector<unsigned char> bytes(3 * static_cast<std::size_t>(small.width) * small.height);
  lambent::Image image;
  image.width = small.width;
  image.height = small.height;
  image.part = { 0, small.width, 0, small.height };
  image.bytes = bytes.data();
  lambent::render(scene, image); // The first picture also selects the kernels.
  measuredRender(scene, image);
  return EXIT_SUCCESS;
}
