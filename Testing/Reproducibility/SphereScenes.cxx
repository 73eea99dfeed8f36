// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with spheres.
#include "Scenes.h"

using lambent::AttributeType;

namespace
{
/// Random points in |x|, |y|, |z| <= 1.
Shape points(RandomNumbers& random, int count)
{
  Shape result;
  for (int k = 0; k < count; ++k)
  {
    result.points.push_back(random.inBox(1.0));
  }
  return result;
}

std::vector<double> sizes(RandomNumbers& random, int count, double low, double high)
{
  std::vector<double> result;
  for (int k = 0; k < count; ++k)
  {
    result.push_back(random.within(low, high));
  }
  return result;
}

/// Spheres of many sizes under daylight.
Body& still(Stage& s)
{
  RandomNumbers random(21);
  s.daylight();
  Body& body = s.add(points(random, 60));
  return body.spheres(0.5, sizes(random, 60, 0.0, 0.75));
}
}

SceneList sphereScenes()
{
  return {
    { "sphere-perspective", [](Stage& s) { still(s); } },
    { "sphere-parallel",
      [](Stage& s)
      {
        still(s).flat().floats();
        s.lookParallel(1.5);
      } },
    { "sphere-of-one-radius",
      [](Stage& s)
      {
        RandomNumbers random(22);
        s.daylight();
        s.add(points(random, 40)).spheres(0.1875).floats();
        s.isFramed = true;
      } },
    { "sphere-samples-3-alpha",
      [](Stage& s)
      {
        still(s);
        s.samples = 3;
        s.hasAlpha = true;
      } },
    { "sphere-among-triangles",
      [](Stage& s)
      {
        ballAndBox(s, 1);
        RandomNumbers random(23);
        s.add(points(random, 30)).spheres(0.25).paint({ 0.9, 0.4, 0.2 });
        s.add(points(random, 30)).spheres(0.0625).unlit();
      } },
    { "sphere-from-inside",
      [](Stage& s)
      {
        s.lamp({ 0.5, 0.25, 0.75 });
        s.add(Shape{ { Vec3(0.0) }, {} }).spheres(3.0);
        s.add(Shape{ { { 0.25, 0.0, -1.0 } }, {} }).spheres(0.5).paint({ 0.2, 0.4, 0.9 });
        s.look({ 0.5, 0.5, 1.5 }, Vec3(0.0));
      } },
    { "sphere-from-inside-one-sided",
      [](Stage& s)
      {
        s.daylight();
        s.scene.twoSidedLighting = false;
        s.add(Shape{ { Vec3(0.0) }, {} }).spheres(3.0);
        s.look({ 0.5, 0.5, 1.5 }, Vec3(0.0));
      } },
    { "sphere-fronts-culled",
      [](Stage& s)
      {
        still(s).appearance.cullFront = true;
        s.bodies.back().spheres(0.75);
      } },
    { "sphere-backs-culled",
      [](Stage& s)
      {
        still(s).appearance.cullBack = true;
        s.look({ 0.25, 0.25, 0.25 }, Vec3(0.0)); // some are around the eye
      } },
    { "sphere-through-the-plane-of-the-eye",
      [](Stage& s)
      {
        RandomNumbers random(24);
        s.lamp({ 0.0, 0.5, 0.0 });
        s.add(scaled(points(random, 200), { 2.0, 2.0, 0.25 })).spheres(0.375);
        s.look(Vec3(0.0), { 0.0, 0.0, -1.0 });
        s.scene.camera.viewAngle = 100.0;
      } },
    { "sphere-through-the-plane-of-a-parallel-eye",
      [](Stage& s)
      {
        RandomNumbers random(25);
        s.daylight();
        s.add(points(random, 50)).spheres(0.375);
        s.look(Vec3(0.0), { 0.0, 0.0, -1.0 });
        s.lookParallel(1.25);
      } },
    { "sphere-between-rays",
      [](Stage& s)
      {
        RandomNumbers random(26);
        s.daylight();
        s.add(points(random, 20000)).spheres(0.005);
      } },
    { "sphere-planet",
      [](Stage& s)
      {
        s.daylight();
        s.add(Shape{ { { 0.0, -6378137.5, 0.0 } }, {} }).spheres(6378137.0);
        s.add(Shape{ { { 0.5, 0.0, 0.0 } }, {} }).spheres(0.5).paint({ 0.9, 0.2, 0.1 });
      } },
    { "sphere-map-coordinates",
      [](Stage& s)
      {
        RandomNumbers random(27);
        const Vec3 origin(476543.125, 5429876.5, 112.75);
        s.sun({ -1.0, -2.0, -1.5 });
        s.add(moved(points(random, 60), origin)).spheres(1.0, sizes(random, 60, 0.05, 0.3));
        s.look(origin + Vec3(2.0, 1.5, 4.0), origin);
      } },
    { "sphere-twice",
      [](Stage& s)
      {
        s.hasTies = true;
        RandomNumbers random(28);
        s.daylight();
        const Shape once = points(random, 30);
        s.add(once).spheres(0.25);
        s.add(once).spheres(0.25).paint({ 0.1, 0.9, 0.1 });
      } },
    { "sphere-not-finite",
      [](Stage& s)
      {
        const double zero = 0.0;
        still(s);
        s.bodies.back().shape.points[3].x = 1.0 / zero;
        s.bodies.back().shape.points[5].y = zero / zero;
      } },
    { "sphere-passes",
      [](Stage& s)
      {
        ballAndBox(s, 1);
        s.bodies[0].pointArray("Heat", 1, AttributeType::Float);
        s.bodies[1].cellArray("Part", 1, AttributeType::Int32);
        RandomNumbers random(29);
        s.add(points(random, 40)).spheres(0.25).pointArray("Heat", 1, AttributeType::Double);
        s.showDepth();
        s.showNormals();
        s.showPositions();
        s.showArray("Heat", false);
        s.showArray("Part", true);
      } },
    { "sphere-passes-parallel-samples-2",
      [](Stage& s)
      {
        still(s).pointArray("Flow", 3, AttributeType::Float);
        s.samples = 2;
        s.lookParallel(1.5);
        s.showDepth();
        s.showNormals();
        s.showPositions();
        s.showArray("Flow", false);
      } },
  };
}
