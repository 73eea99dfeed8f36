// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with many triangles, or with many in the same place.
#include "Scenes.h"

namespace
{
void cloud(Stage& s, unsigned int seed, int count, double size)
{
  RandomNumbers random(seed);
  s.daylight();
  s.add(soup(random, count, size)).flat();
}
}

SceneList crowdScenes()
{
  return {
    { "crowd-large-triangles", [](Stage& s) { cloud(s, 1, 200, 0.75); } },
    { "crowd-triangles-of-some-pixels", [](Stage& s) { cloud(s, 2, 4000, 0.05); } },
    { "crowd-triangles-of-a-pixel", [](Stage& s) { cloud(s, 3, 20000, 0.0125); } },
    { "crowd-triangles-between-rays", [](Stage& s) { cloud(s, 4, 60000, 0.002); } },
    { "crowd-of-all-sizes",
      [](Stage& s)
      {
        RandomNumbers random(5);
        s.daylight();
        for (double size = 1.0; size > 1e-4; size *= 0.25)
        {
          s.add(soup(random, 300, size)).flat();
        }
      } },
    { "crowd-closed-mesh",
      [](Stage& s)
      {
        s.daylight();
        s.add(ball(6)).round();
      } },
    { "crowd-closed-mesh-apart",
      [](Stage& s)
      {
        s.daylight();
        s.add(apart(ball(5))).flat();
      } },
    { "crowd-closed-mesh-from-afar",
      [](Stage& s)
      {
        s.daylight();
        s.add(ball(6));
        s.look({ 20.0, 15.0, 40.0 }, Vec3(0.0));
      } },
    { "crowd-in-one-pixel",
      [](Stage& s)
      {
        RandomNumbers random(6);
        s.size(97, 73); // with a ray through the middle
        s.daylight();
        s.add(scaled(soup(random, 30000, 0.5), Vec3(0.01))).flat();
      } },
    { "crowd-in-one-tile",
      [](Stage& s)
      {
        RandomNumbers random(7);
        s.daylight();
        s.add(scaled(soup(random, 20000, 0.2), Vec3(0.25))).flat();
      } },
    { "crowd-64-layers",
      [](Stage& s)
      {
        s.daylight();
        s.add(layers(64)).flat();
      } },
    { "crowd-64-layers-from-behind",
      [](Stage& s)
      {
        s.lamp({ -1.0, 2.0, -3.0 });
        s.add(layers(64));
        s.look({ 0.5, -1.0, -4.0 }, Vec3(0.0));
      } },
    { "crowd-fan-of-a-thousand",
      [](Stage& s)
      {
        RandomNumbers random(8);
        s.daylight();
        Shape fan;
        fan.points.push_back({ 0.1, 0.2, 0.3 });
        for (std::int64_t k = 1; k <= 1000; ++k)
        {
          fan.points.push_back(random.inBox(1.0));
          fan.cells.push_back({ 0, k, k % 1000 + 1 });
        }
        s.add(fan);
      } },
    { "crowd-coincident-faces",
      [](Stage& s)
      {
        s.hasTies = true;
        s.daylight();
        for (int k = 0; k < 4; ++k)
        {
          s.add(square(2 + k % 2)).flat().paint({ 0.2 * k, 1.0 - 0.2 * k, 0.5 });
        }
      } },
    { "crowd-almost-coincident-faces",
      [](Stage& s)
      {
        s.hasTies = true; // some depths round to the same number
        RandomNumbers random(9);
        s.daylight();
        for (int k = 0; k < 6; ++k)
        {
          Body& body = s.add(square(3)).flat().paint({ 0.15 * k, 1.0 - 0.15 * k, 0.5 });
          for (Vec3& p : body.shape.points)
          {
            p = p + random.inBox(1e-15);
          }
        }
      } },
    { "crowd-of-doubles",
      [](Stage& s)
      {
        s.hasTies = true;
        RandomNumbers random(10);
        s.daylight();
        const Shape once = soup(random, 300, 0.25);
        s.add(joined(once, once)).flat();
        s.add(once).flat().paint({ 0.1, 0.9, 0.1 });
      } },
    { "crowd-grid-on-the-rays",
      [](Stage& s)
      {
        s.hasTies = true; // rays hit points and edges exactly
        s.size(64, 48);
        s.daylight();
        s.add(scaled(square(64), Vec3(32.0))).flat();
        s.add(moved(scaled(hills(32), Vec3(16.0)), { 0.0, 0.0, 1.0 }));
        s.look({ 0.5, 0.5, 40.0 }, { 0.5, 0.5, 0.0 });
        s.lookParallel(24.0);
      } },
  };
}
