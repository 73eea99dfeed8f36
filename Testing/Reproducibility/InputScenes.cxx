// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Composite inputs, transforms and ghost cells.
#include "Scenes.h"

namespace
{
constexpr unsigned char duplicate = 1, hiddenPoint = 2, refined = 8, hidden = 32;

/// A rotation by an angle with the cosine 3/5 about y, then by one with the cosine 5/13 about x.
Body& turn(Body& body)
{
  return body.place({ 0.6, 0.0, 0.8 }, { 48.0 / 65.0, 5.0 / 13.0, -36.0 / 65.0 },
    { -4.0 / 13.0, 12.0 / 13.0, 3.0 / 13.0 }, { 0.25, -0.125, 0.0625 });
}

/// Squeezes and shears.
Body& distort(Body& body)
{
  return body.place({ 1.25, 0.25, 0.0 }, { 0.0, 0.4, 0.3 }, { -0.125, 0.0, 0.75 }, Vec3(0.0625));
}

/// Mirrors and shears.
Body& mirror(Body& body)
{
  return body.place({ -0.9, 0.25, 0.0 }, { 0.0, 0.7, 0.3 }, { 0.125, 0.0, 0.75 }, Vec3(0.0625));
}

/// Boxes in blocks of two levels.
void assembly(Stage& s)
{
  s.daylight();
  int number = 0;
  for (const std::vector<int>& place :
    { std::vector<int>{ 0 }, { 1, 0 }, { 1, 2 }, { 3, 1, 0 }, { 3, 1, 1 }, { 4 } })
  {
    Body& body = s.add(moved(box({ 0.25, 0.5, 0.375 }), { 0.5 * number - 1.25, 0.0, 0.0 }));
    body.flat().inBlock(place);
    body.blockColor = number % 2 ? std::optional<Vec3>({ 0.15 * number, 0.5, 0.25 }) : std::nullopt;
    ++number;
  }
}

/// Marks every k-th cell.
void mark(Body& body, std::size_t k, unsigned char flag)
{
  body.cellGhosts.resize(body.shape.cells.size());
  for (std::size_t cell = 0; cell < body.cellGhosts.size(); cell += k)
  {
    body.cellGhosts[cell] |= flag;
  }
}
}

SceneList inputScenes()
{
  return {
    { "input-blocks", assembly },
    { "input-blocks-that-coincide",
      [](Stage& s)
      {
        s.daylight();
        s.hasTies = true;
        for (int k = 0; k < 3; ++k)
        {
          s.add(ball(2)).inBlock({ k }).blockColor = Vec3(0.3 * k, 0.9 - 0.3 * k, 0.25);
        }
      } },
    { "input-blocks-hidden",
      [](Stage& s)
      {
        assembly(s);
        s.hiddenBlocks = { { 1 }, { 3, 1, 1 } };
      } },
    { "input-blocks-transformed-and-framed",
      [](Stage& s)
      {
        assembly(s);
        turn(s.bodies.front());
        s.add(moved(ball(2), { 0.0, 2.0, 0.0 })).round();
        s.hiddenBlocks = { { 4 } };
        s.isFramed = true;
      } },
    { "input-rotated-flat",
      [](Stage& s)
      {
        s.daylight();
        turn(s.add(box({ 1.0, 0.75, 0.5 }))).flat();
      } },
    { "input-rotated-own-normals",
      [](Stage& s)
      {
        s.daylight();
        turn(s.add(ball(3)).round());
      } },
    { "input-rotated-floats-computed-normals",
      [](Stage& s)
      {
        s.daylight();
        turn(s.add(hills(12)).floats());
        s.showPositions();
      } },
    { "input-scaled-own-normals",
      [](Stage& s)
      {
        s.daylight();
        distort(s.add(ball(3)).round());
      } },
    { "input-scaled-cell-normals",
      [](Stage& s)
      {
        s.daylight();
        Body& body = distort(s.add(ball(2)).flat());
        for (const auto& cell : body.shape.cells)
        {
          body.cellNormals.push_back(body.shape.points[cell[0]]);
        }
      } },
    { "input-scaled-computed-normals",
      [](Stage& s)
      {
        s.daylight();
        distort(s.add(cylinder(4)));
        s.showPositions();
        s.showNormals();
        s.showDepth();
      } },
    { "input-mirrored-flat-culled",
      [](Stage& s)
      {
        s.daylight();
        s.scene.twoSidedLighting = false;
        mirror(s.add(cylinder(5)).flat()).appearance.cullBack = true;
        s.look({ 1.0, 3.0, 2.5 }, Vec3(0.0));
      } },
    { "input-mirrored-own-normals-one-sided",
      [](Stage& s)
      {
        s.daylight();
        s.scene.twoSidedLighting = false;
        mirror(s.add(ball(3)).round()).appearance.cullBack = true;
      } },
    { "input-mirrored-computed-normals-one-sided",
      [](Stage& s)
      {
        s.daylight();
        s.scene.twoSidedLighting = false;
        mirror(s.add(apart(ball(1)))).appearance.cullBack = true;
        mirror(s.add(joined(ball(3), moved(ball(1), { 0.5, 1.0, 0.5 }))));
        s.showNormals();
      } },
    { "input-mirrored-strips",
      [](Stage& s)
      {
        s.daylight();
        s.scene.twoSidedLighting = false;
        mirror(s.add(ribbons(9)).strips().flat());
        s.look({ 2.0, 1.5, 4.0 }, Vec3(0.0));
      } },
    { "input-ghosts-flat",
      [](Stage& s)
      {
        s.daylight();
        Body& body = s.add(ball(3)).flat();
        mark(body, 5, duplicate);
        mark(body, 7, hidden);
        mark(body, 11, refined);
      } },
    { "input-ghosts-computed-normals",
      [](Stage& s)
      {
        s.daylight();
        Body& body = s.add(hills(12)).floats();
        mark(body, 5, duplicate);
        mark(body, 7, hidden);
      } },
    { "input-ghost-quads-with-hidden-points",
      [](Stage& s)
      {
        s.daylight();
        Body& body = s.add(cylinder(6));
        body.pointGhosts.resize(body.shape.points.size());
        body.pointGhosts[3] = hiddenPoint;
        body.pointGhosts[16] = duplicate;
        mark(body, 9, duplicate);
        s.look({ 2.0, 3.0, 2.5 }, Vec3(0.0));
      } },
    { "input-ghost-strips-mirrored",
      [](Stage& s)
      {
        s.daylight();
        s.scene.twoSidedLighting = false;
        Body& body = mirror(s.add(ribbons(17)).strips());
        for (Vec3& p : body.shape.points)
        {
          p.z = (p.x * p.y) * (1.0 - p.x * p.x);
        }
        mark(body, 3, duplicate);
        mark(body, 4, hidden);
      } },
  };
}
