// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines along the edges of cells.
#include "Scenes.h"

using lambent::AttributeType;

namespace
{
constexpr unsigned char duplicate = 1, hidden = 32;

Body& lined(Body& body, double width, const Vec3& color = Vec3(0.0))
{
  body.appearance.edges.areVisible = true;
  body.appearance.edges.width = width;
  body.appearance.edges.color = color;
  return body;
}

/// A box of quads next to a ball of triangles.
void solids(Stage& s, double width)
{
  s.daylight();
  lined(s.add(moved(box({ 0.75, 0.5, 0.625 }), { -0.75, 0.125, 0.0 })).flat(), width);
  lined(s.add(moved(scaled(ball(2), Vec3(0.75)), { 0.875, 0.0, 0.25 })), width, { 0.9, 0.1, 0.2 });
}

/// A sheet of boxes at this scale.
void scaledSolids(Stage& s, double scale, const Vec3& offset)
{
  s.daylight();
  s.look(offset + Vec3(2.0, 1.5, 4.0) * scale, offset);
  for (int k = 0; k < 3; ++k)
  {
    Shape shape = moved(box({ 0.25, 0.5 + 0.25 * k, 0.5 }), { k - 1.0, 0.0, -0.25 * k });
    for (Vec3& p : shape.points)
    {
      p = offset + p * scale;
    }
    lined(s.add(shape).flat(), 1.5);
  }
}
}

SceneList edgeScenes()
{
  return {
    { "edges-solids", [](Stage& s) { solids(s, 1.0); } },
    { "edges-wide",
      [](Stage& s)
      {
        solids(s, 5.5);
        s.bodies[1].unlit();
      } },
    { "edges-samples-3-alpha-passes",
      [](Stage& s)
      {
        solids(s, 1.25);
        s.samples = 3;
        s.hasAlpha = true;
        s.showDepth();
        s.showNormals();
      } },
    { "edges-parallel",
      [](Stage& s)
      {
        solids(s, 2.0);
        s.lookParallel(1.5);
      } },
    { "edges-concave-polygons",
      [](Stage& s)
      {
        s.daylight();
        lined(s.add(moved(star(7), { -0.75, 0.0, 0.0 })), 3.0);
        lined(s.add(moved(scaled(star(29), Vec3(0.75)), { 1.0, 0.25, 0.5 })), 1.0);
      } },
    { "edges-of-strips",
      [](Stage& s)
      {
        s.daylight();
        lined(s.add(ribbons(9)).strips().flat(), 1.5);
        lined(s.add(moved(ribbons(2), { -1.25, 0.75, 0.25 })).strips().floats().flat(), 2.0);
      } },
    { "edges-of-some",
      [](Stage& s)
      {
        solids(s, 1.5);
        s.bodies[0].appearance.edges.areVisible = false;
        lined(s.add(moved(ball(1), { 0.0, 0.75, -0.5 })).spheres(0.25), 3.0); // spheres have none
        lined(s.add(moved(hills(9), { 0.0, -0.75, 0.0 })), 0.75, { 1.0, 1.0, 0.25 });
      } },
    { "edges-colors",
      [](Stage& s)
      {
        solids(s, 2.0);
        s.bodies[1].flat();
        for (Body& body : s.bodies)
        {
          body.cellArray("Shade", 4, AttributeType::UInt8);
          body.pointArray("Paint", 3, AttributeType::UInt8);
        }
        s.bodies[0].colorBy("Shade", true).hasAlpha = true;
        s.bodies[1].colorBy("Paint", false);
      } },
    { "edges-ghosts-mirrored",
      [](Stage& s)
      {
        s.daylight();
        Body& body = lined(s.add(cylinder(6)).flat(), 2.5);
        body.place({ -0.9, 0.25, 0.0 }, { 0.0, 0.7, 0.3 }, { 0.125, 0.0, 0.75 }, Vec3(0.0625));
        body.cellGhosts.resize(body.shape.cells.size());
        body.cellGhosts[1] = hidden;
        body.cellGhosts[8] = duplicate;
        s.look({ 2.0, 3.0, 2.5 }, Vec3(0.0));
      } },
    { "edges-blocks",
      [](Stage& s)
      {
        s.daylight();
        for (int k = 0; k < 3; ++k)
        {
          Body& body = s.add(moved(box({ 0.25, 0.5, 0.375 }), { k - 1.0, 0.0, 0.0 })).flat();
          body.inBlock({ k }).blockColor = Vec3(0.3 * k, 0.5, 0.25);
          lined(body, 1.5, { 0.0, 0.0, 0.5 });
        }
      } },
    { "edges-tiny", [](Stage& s) { scaledSolids(s, 1e-6, Vec3(0.0)); } },
    { "edges-far-from-the-origin", [](Stage& s) { scaledSolids(s, 1e3, Vec3(5e6, -5e6, 5e6)); } },
    { "edges-behind-the-eye",
      [](Stage& s)
      {
        s.daylight();
        s.look({ 0.25, 0.125, 0.5 }, { 0.0, -0.25, -1.0 });
        lined(s.add(box({ 1.0, 0.75, 2.0 })).flat(), 3.0);
        lined(s.add(square(2)).flat(), 2.0, { 1.0, 1.0, 1.0 });
        s.bodies[1].place({ 0, 0, 3 }, { 0, 1, 0 }, { 1, 0, 0 }, { 0.5, 0, 0 });
      } },
  };
}
