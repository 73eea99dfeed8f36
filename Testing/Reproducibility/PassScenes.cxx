// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Passes: depth, normals, positions and attributes.
#include "Scenes.h"

using lambent::AttributeType;

namespace
{
/// A smooth ball, a flat box, an unlit sheet seen from behind, and a smooth tube seen from inside.
void still(Stage& s)
{
  ballAndBox(s, 1);
  s.add(turned(moved(square(3), { -1.0, 0.5, -0.75 }))).unlit().paint({ 0.9, 0.6, 0.3 });
  Body& tube = s.add(moved(cylinder(6), { -1.25, 0.0, 0.5 }));
  for (const Vec3& p : tube.shape.points)
  {
    tube.pointNormals.emplace_back(p.x + 1.25, 0.0, p.z - 0.5);
  }
}

/// The same with arrays, some of which some bodies lack.
void stillWithArrays(Stage& s)
{
  still(s);
  s.bodies[0].pointArray("Heat", 1, AttributeType::Float);
  s.bodies[0].pointArray("Flow", 3, AttributeType::Double);
  s.bodies[0].cellArray("Part", 1, AttributeType::Int32);
  s.bodies[1].pointArray("Heat", 1, AttributeType::UInt8);
  s.bodies[1].cellArray("Part", 1, AttributeType::UInt8);
  s.bodies[1].cellArray("Shade", 4, AttributeType::UInt8);
  s.bodies[2].pointArray("Flow", 3, AttributeType::Float);
  s.bodies[3].pointArray("Heat", 1, AttributeType::Float);
  s.bodies[3].cellArray("Shade", 4, AttributeType::UInt8);
}
}

SceneList passScenes()
{
  return {
    { "pass-depth",
      [](Stage& s)
      {
        still(s);
        s.showDepth();
      } },
    { "pass-depth-parallel",
      [](Stage& s)
      {
        still(s);
        s.lookParallel(1.625);
        s.showDepth();
      } },
    { "pass-normals",
      [](Stage& s)
      {
        still(s);
        s.showNormals();
      } },
    { "pass-normals-one-sided-samples-2",
      [](Stage& s)
      {
        still(s);
        s.samples = 2;
        s.scene.twoSidedLighting = false;
        s.showNormals();
      } },
    { "pass-positions",
      [](Stage& s)
      {
        still(s);
        s.showPositions();
      } },
    { "pass-positions-parallel-samples-3",
      [](Stage& s)
      {
        still(s);
        s.samples = 3;
        s.lookParallel(1.625);
        s.showPositions();
      } },
    { "pass-point-arrays",
      [](Stage& s)
      {
        stillWithArrays(s);
        s.showArray("Heat", false);
        s.showArray("Flow", false);
      } },
    { "pass-cell-arrays",
      [](Stage& s)
      {
        stillWithArrays(s);
        s.showArray("Part", true);
        s.showArray("Shade", true);
      } },
    { "pass-all-alpha-samples-3",
      [](Stage& s)
      {
        stillWithArrays(s);
        s.samples = 3;
        s.hasAlpha = true;
        s.size(67, 41);
        s.showDepth();
        s.showNormals();
        s.showPositions();
        s.showArray("Heat", false);
        s.showArray("Shade", true);
        s.showArray("Missing", true);
      } },
    { "pass-all-of-nothing",
      [](Stage& s)
      {
        s.showDepth();
        s.showNormals();
        s.showPositions();
        s.showArray("Missing", false);
      } },
  };
}
