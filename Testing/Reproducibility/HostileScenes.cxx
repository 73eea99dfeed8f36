// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes that trip up renderers: thin, tiny, huge, far away, behind the eye, NaN.
#include "Scenes.h"

#include <limits>

namespace
{
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double denormal = std::numeric_limits<double>::denorm_min();

/// A ball and its lights, scaled to a size and moved from the origin.
void ballOfSize(Stage& s, double size, const Vec3& from = Vec3(0.0))
{
  s.sun({ -1.0, -2.0, -1.5 }, { 0.75, 0.7, 0.6 });
  s.lamp(from + Vec3(-3.0, 1.0, 2.0) * size, { 0.2, 0.3, 0.5 });
  s.add(moved(scaled(ball(3), Vec3(size)), from));
  s.look(from + Vec3(2.0, 1.5, 4.0) * size, from);
}

/// Large triangles on all sides of an eye at the origin.
Shape around(RandomNumbers& random, int count)
{
  Shape shape;
  for (int k = 0; k < count; ++k)
  {
    const Vec3 a = random.inBox(4.0), b = random.inBox(4.0), c = random.inBox(4.0);
    shape.add(a, b, c);
  }
  return shape;
}

/// A soup in which one coordinate of every third triangle is replaced.
void spoilt(Stage& s, unsigned int seed, const std::vector<double>& values)
{
  RandomNumbers random(seed);
  s.daylight();
  Body& body = s.add(soup(random, 300, 0.25)).flat();
  std::vector<Vec3>& points = body.shape.points;
  for (std::size_t p = 0; p < points.size(); p += 9)
  {
    points[p + random.below(3)][random.below(3)] =
      values[random.below(static_cast<int>(values.size()))];
  }
}

void thin(Stage& s, unsigned int seed, double width)
{
  RandomNumbers random(seed);
  s.daylight();
  s.add(needles(random, 500, width)).flat();
}

/// A triangle along each column of rays, at most a few ulps wide; some have zero width.
void sliversOnRays(Stage& s)
{
  RandomNumbers random(13);
  s.size(64, 48);
  s.look({ 0.0, 0.0, 4.0 }, Vec3(0.0));
  s.lookParallel(0.75); // rays are 1/32 apart
  s.daylight();
  Shape shape;
  for (int k = 0; k < 64; ++k)
  {
    const double x = (k - 31.5) / 32.0, width = k % 8 * 0x1p-53;
    const double a = x - width * random.below(3), b = x + width * random.below(3);
    shape.add({ a, -0.7, random.within(-1.0, 1.0) }, { b, -0.6, 0.0 }, { x, 0.7, 0.0 });
  }
  s.add(shape).flat();
}
}

SceneList hostileScenes()
{
  return {
    { "hostile-not-a-number", [](Stage& s) { spoilt(s, 1, { notANumber }); } },
    { "hostile-infinite",
      [](Stage& s) {
        spoilt(s, 2, { infinity, -infinity });
      } },
    { "hostile-denormal",
      [](Stage& s) {
        spoilt(s, 3, { denormal, -denormal, 1e-310, -0.0 });
      } },
    { "hostile-beyond-all-bounds",
      [](Stage& s) {
        spoilt(s, 4, { 1e40, -1e70, 1e150 });
      } },
    { "hostile-not-a-number-smooth",
      [](Stage& s)
      {
        s.daylight();
        Body& body = s.add(ball(3));
        body.shape.points[17].x = notANumber;
        body.shape.points[40].y = infinity;
        body.shape.points.push_back(Vec3(notANumber)); // not used by any cell
      } },
    { "hostile-needles", [](Stage& s) { thin(s, 5, 1e-2); } },
    { "hostile-slivers", [](Stage& s) { thin(s, 6, 1e-4); } },
    { "hostile-slivers-of-an-ulp", [](Stage& s) { thin(s, 7, 2e-16); } },
    { "hostile-slivers-on-the-rays", [](Stage& s) { sliversOnRays(s); } },
    { "hostile-no-width", [](Stage& s) { thin(s, 8, 0.0); } },
    { "hostile-edge-on",
      [](Stage& s)
      {
        s.hasTies = true; // along the edges
        s.size(65, 49);
        s.daylight();
        s.add(square(8)).flat();
        s.add(moved(scaled(square(8), Vec3(0.5)), { 0.0, 0.0, -0.0625 })).flat();
        s.look({ 0.0, 4.0, 0.0 }, Vec3(0.0), { 0.0, 0.0, 1.0 });
      } },
    { "hostile-one-huge-triangle",
      [](Stage& s)
      {
        s.daylight();
        s.add(triangle({ -1e9, -2e9, -3.0 }, { 2e9, -1e9, -2.0 }, { 0.0, 3e9, 1.0 })).flat();
      } },
    { "hostile-behind-the-eye",
      [](Stage& s)
      {
        s.daylight();
        s.add(moved(ball(3), { 4.0, 3.0, 8.0 }));
        s.add(scaled(ball(2), Vec3(0.5)));
      } },
    { "hostile-through-the-plane-of-the-eye",
      [](Stage& s)
      {
        RandomNumbers random(9);
        s.daylight();
        s.add(around(random, 60)).flat();
        s.look(Vec3(0.0), { 1.0, 2.0, -3.0 });
        s.scene.camera.viewAngle = 70.0;
      } },
    { "hostile-through-the-plane-of-a-parallel-eye",
      [](Stage& s)
      {
        RandomNumbers random(10);
        s.daylight();
        s.add(around(random, 60)).flat();
        s.look(Vec3(0.0), { 1.0, 2.0, -3.0 });
        s.lookParallel(3.0);
      } },
    { "hostile-corners-in-the-eye",
      [](Stage& s)
      {
        RandomNumbers random(11);
        s.daylight();
        Shape shape = around(random, 40);
        for (std::size_t p = 0; p < shape.points.size(); p += 12)
        {
          shape.points[p] = Vec3(0.0);
          shape.points[p + 3] = -shape.points[p + 4]; // an edge through the eye
        }
        s.add(shape).flat();
        s.look(Vec3(0.0), { -1.0, 0.5, -2.0 });
        s.scene.camera.viewAngle = 110.0;
      } },
    { "hostile-wall-before-the-eye",
      [](Stage& s)
      {
        s.daylight();
        s.add(square(40)).flat();
        s.look({ 0.1, 0.2, 1e-7 }, { 0.3, 0.4, 0.0 });
        s.scene.camera.viewAngle = 90.0;
      } },
    { "hostile-near-and-far",
      [](Stage& s)
      {
        RandomNumbers random(12);
        s.daylight();
        s.add(soup(random, 100, 0.5)).flat();
        s.add(moved(scaled(soup(random, 100, 0.5), Vec3(1e-6)), { 1.999999, 1.4999993, 3.999998 }));
        s.add(moved(scaled(ball(3), Vec3(1e8)), { -2e8, -1.5e8, -4e8 })).paint({ 0.1, 0.2, 0.9 });
      } },
    { "hostile-tiny", [](Stage& s) { ballOfSize(s, 1e-30); } },
    { "hostile-huge", [](Stage& s) { ballOfSize(s, 1e30); } },
    { "hostile-map-coordinates",
      [](Stage& s) {
        ballOfSize(s, 1e-3, { 500000.125, 5420000.0625, 112.0 });
      } },
    { "hostile-map-coordinates-in-floats",
      [](Stage& s)
      {
        ballOfSize(s, 8.0, { 500000.0, 5420000.0, 112.0 });
        s.bodies[0].floats();
      } },
    { "hostile-lost-far-away",
      [](Stage& s)
      {
        s.hasTies = true; // points collapse by rounding
        ballOfSize(s, 1.0, { 1e15, -1e15, 3e15 });
      } },
    { "hostile-normals-that-are-none",
      [](Stage& s)
      {
        s.daylight();
        Body& body = s.add(ball(3)).round();
        for (std::size_t k = 0; k < body.pointNormals.size(); k += 5)
        {
          body.pointNormals[k] = k % 2 ? Vec3(notANumber) : Vec3(0.0, infinity, 0.0);
        }
      } },
    { "hostile-polygons",
      [](Stage& s)
      {
        s.daylight();
        Body& body = s.add(star(3)).flat();
        // With two points, one, none; with repeated points; self-intersecting.
        body.shape.cells.insert(body.shape.cells.end(),
          { { 0, 1 }, { 2 }, {}, { 3, 3, 4, 4, 5 }, { 0, 6, 3, 9 }, { 7, 1, 7, 2, 7 } });
      } },
  };
}
