// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with lines and points of a width in pixels.
#include "Scenes.h"

using lambent::AttributeType;

namespace
{
/// Polylines of this many segments of about this length, in |x|, |y|, |z| <= 1 or a little beyond.
Shape polylines(RandomNumbers& random, int count, int segments, double length)
{
  Shape result;
  for (int k = 0; k < count; ++k)
  {
    Vec3 end = random.inBox(1.0);
    result.cells.emplace_back();
    for (int point = 0; point <= segments; ++point)
    {
      result.cells.back().push_back(static_cast<std::int64_t>(result.points.size()));
      result.points.push_back(end);
      end = end + random.inBox(length);
    }
  }
  return result;
}

/// One vertex at each of some random points.
Shape vertices(RandomNumbers& random, int count)
{
  Shape result;
  for (int k = 0; k < count; ++k)
  {
    result.cells.push_back({ k });
    result.points.push_back(random.inBox(1.0));
  }
  return result;
}

/// Separate lines under daylight.
Body& needles(Stage& s, double width)
{
  RandomNumbers random(31);
  s.daylight();
  return s.add(polylines(random, 60, 1, 0.75)).lines(CellShow::Polylines, width);
}
}

SceneList lineScenes()
{
  return {
    { "line-perspective",
      [](Stage& s) {
        needles(s, 1.0).paint({ 0.9, 0.7, 0.2 });
      } },
    { "line-parallel",
      [](Stage& s)
      {
        needles(s, 2.5).flat().floats();
        s.lookParallel(1.5);
      } },
    { "line-tubes", [](Stage& s) { needles(s, 9.0).tubes(CellShow::Polylines, 9.0); } },
    { "line-samples-3-alpha",
      [](Stage& s)
      {
        needles(s, 1.5);
        s.samples = 3;
        s.hasAlpha = true;
      } },
    { "line-joints",
      [](Stage& s)
      {
        RandomNumbers random(32);
        s.daylight();
        s.hasTies = true;
        s.add(polylines(random, 8, 12, 0.5)).lines(CellShow::Polylines, 6.5);
      } },
    { "line-normals-of-points",
      [](Stage& s)
      {
        Body& body = needles(s, 5.0);
        body.round();
        s.isFramed = true;
      } },
    { "line-wireframe",
      [](Stage& s)
      {
        s.daylight();
        s.hasTies = true;
        s.add(ball(2)).lines(CellShow::Edges, 1.0).paint({ 0.2, 0.8, 0.6 });
      } },
    { "line-wireframe-of-polygons-and-strips",
      [](Stage& s)
      {
        s.daylight();
        s.hasTies = true;
        s.add(moved(star(7), { 0.0, 0.0, -0.5 })).lines(CellShow::Edges, 3.0).flat();
        s.add(ribbons(4)).strips().lines(CellShow::Edges, 1.5).unlit();
      } },
    { "line-wireframe-on-its-faces",
      [](Stage& s)
      {
        s.lamp({ 1.0, 2.0, 3.0 });
        s.hasTies = true;
        s.add(hills(9)).paint({ 0.3, 0.5, 0.9 });
        s.add(hills(9)).lines(CellShow::Edges, 1.75).unlit().paint({ 0.9, 0.9, 0.9 });
        s.look({ 0.5, -2.0, 1.25 }, Vec3(0.0));
      } },
    { "line-points-of-cells",
      [](Stage& s)
      {
        s.daylight();
        s.add(ball(2)).lines(CellShow::Points, 3.5);
      } },
    { "line-vertices",
      [](Stage& s)
      {
        RandomNumbers random(33);
        s.daylight();
        s.add(vertices(random, 200)).lines(CellShow::Vertices, 4.0).floats();
        s.lookParallel(1.25);
      } },
    { "line-points-as-spheres",
      [](Stage& s)
      {
        RandomNumbers random(34);
        s.daylight();
        s.add(vertices(random, 50)).tubes(CellShow::Vertices, 15.0);
        s.look({ 0.25, 0.5, 1.5 }, Vec3(0.0)); // some are at the edges of a wide view
        s.scene.camera.viewAngle = 75.0;
      } },
    { "line-through-the-plane-of-the-eye",
      [](Stage& s)
      {
        RandomNumbers random(35);
        s.lamp({ 0.0, 0.5, 0.0 });
        s.add(polylines(random, 150, 1, 3.0)).lines(CellShow::Polylines, 2.0);
        s.look(Vec3(0.0), { 0.0, 0.0, -1.0 });
        s.scene.camera.viewAngle = 100.0;
      } },
    { "line-through-the-plane-of-a-parallel-eye",
      [](Stage& s)
      {
        RandomNumbers random(36);
        s.daylight();
        s.add(polylines(random, 150, 1, 3.0)).tubes(CellShow::Polylines, 7.0);
        s.look(Vec3(0.0), { 0.0, 0.0, -1.0 });
        s.lookParallel(1.5);
      } },
    { "line-colours-of-points",
      [](Stage& s)
      {
        Body& body = needles(s, 3.0).pointArray("Heat", 1, AttributeType::Float);
        StageColors& colors = body.colorBy("Heat", false);
        colors.entries = { 0, 0, 255, 255, 0, 255, 0, 255, 255, 255, 0, 255, 255, 0, 0, 255 };
        colors.low = -1.0;
        colors.isMappedLast = true;
      } },
    { "line-colours-of-cells",
      [](Stage& s)
      {
        s.daylight();
        s.hasTies = true;
        Body& body = s.add(box({ 1.0, 0.75, 0.5 })).lines(CellShow::Edges, 4.0);
        body.cellArray("Paint", 3, AttributeType::UInt8);
        body.colorBy("Paint", true);
      } },
    { "line-passes",
      [](Stage& s)
      {
        needles(s, 3.0)
          .pointArray("Flow", 3, AttributeType::Double)
          .cellArray("Part", 1, AttributeType::Float);
        s.showDepth();
        s.showNormals();
        s.showPositions();
        s.showArray("Flow", false);
        s.showArray("Part", true);
      } },
    { "line-among-triangles-and-spheres",
      [](Stage& s)
      {
        ballAndBox(s, 2);
        RandomNumbers random(37);
        s.add(polylines(random, 40, 1, 1.5)).lines(CellShow::Polylines, 2.0);
        s.add(vertices(random, 20)).spheres(0.125);
        s.add(vertices(random, 40)).tubes(CellShow::Vertices, 6.0).paint({ 0.9, 0.3, 0.1 });
      } },
    { "line-mirrored",
      [](Stage& s)
      {
        needles(s, 4.0).place(
          { -1.0, 0.25, 0.0 }, { 0.0, 0.75, 0.0 }, { 0.5, 0.0, 1.0 }, { 0.25, 0.0, -0.5 });
      } },
    { "line-tiny-and-long",
      [](Stage& s)
      {
        RandomNumbers random(38);
        s.daylight();
        s.add(polylines(random, 30, 1, 1e-12)).lines(CellShow::Polylines, 3.0);
        s.add(polylines(random, 30, 1, 1e9)).lines(CellShow::Polylines, 1.25);
      } },
  };
}
