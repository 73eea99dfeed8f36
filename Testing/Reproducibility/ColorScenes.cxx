// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours from arrays of points and cells, as they are and through tables.
#include "Scenes.h"

#include <limits>

using lambent::AttributeType;

namespace
{
/// A hilly sheet and a ball with normals of their own, both with numbers and bytes.
void landscape(Stage& s)
{
  s.daylight();
  Body& ground = s.add(moved(hills(12), { 0.0, -0.5, 0.0 }));
  ground.flat();
  Body& globe = s.add(moved(ball(3), { 0.25, 0.75, 0.5 }));
  for (const Vec3& p : globe.shape.points)
  {
    globe.pointNormals.emplace_back(p.x - 0.25, p.y - 0.75, p.z - 0.5);
  }
  for (Body& body : s.bodies)
  {
    body.appearance.ambient = 0.25;
    body.pointArray("Heat", 1, AttributeType::Float);
    body.pointArray("Flow", 3, AttributeType::Double);
    body.pointArray("Paint", 3, AttributeType::UInt8);
    body.cellArray("Part", 1, AttributeType::Int32);
    body.cellArray("Shade", 4, AttributeType::UInt8);
    StageArray& shade = body.arrays.back();
    for (std::size_t k = 3; k < shade.values.size(); k += 4)
    {
      shade.values[k] = 255.0; // opaque
    }
  }
}

/// Colours of an array, of both bodies.
void colorBy(Stage& s, const std::string& name, bool isPerCell)
{
  for (Body& body : s.bodies)
  {
    body.colorBy(name, isPerCell);
  }
}

/// Gives both bodies a table of so many colours, besides three special ones.
void map(Stage& s, int count, double low, double high)
{
  for (Body& body : s.bodies)
  {
    StageColors& colors = body.colors;
    colors.low = low;
    colors.high = high;
    colors.hasSpecialColors = true;
    for (int k = 0; k < count + 3; ++k)
    {
      const auto byte = [k](int factor) { return static_cast<unsigned char>(k * factor % 256); };
      colors.entries.insert(colors.entries.end(), { byte(67), byte(29), byte(151), 255 });
    }
  }
}
}

SceneList colorScenes()
{
  return {
    { "color-points",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Paint", false);
      } },
    { "color-cells",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Shade", true);
      } },
    { "color-points-unlit",
      [](Stage& s)
      {
        landscape(s);
        s.bodies[0].unlit();
        s.bodies[1].unlit();
        colorBy(s, "Paint", false);
      } },
    { "color-some",
      [](Stage& s)
      {
        landscape(s);
        s.add(moved(box({ 0.5, 0.25, 0.5 }), { -0.75, 0.5, 0.0 }))
          .paint({ 0.75, 0.25, 0.5 })
          .flat();
        s.bodies[0].colorBy("Shade", true);
        s.bodies[1].colorBy("Paint", false);
      } },
    { "color-table-points",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Heat", false);
        map(s, 16, 75.0, 130.0);
      } },
    { "color-table-points-mapped-last",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Heat", false);
        map(s, 16, 75.0, 130.0);
        s.bodies[0].colors.isMappedLast = s.bodies[1].colors.isMappedLast = true;
      } },
    { "color-table-mapped-first-and-last",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Heat", false);
        map(s, 7, 75.0, 130.0);
        s.bodies[1].colors.isMappedLast = true;
        s.bodies[1].unlit();
      } },
    { "color-table-cells",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Part", true);
        map(s, 5, 10.0, 90.0);
      } },
    { "color-table-magnitude",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Flow", false);
        map(s, 32, 90.0, 190.0);
        s.bodies[0].colors.component = s.bodies[1].colors.component = -1;
        s.bodies[1].colors.isMappedLast = true;
      } },
    { "color-table-logarithmic",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Flow", false);
        map(s, 64, 10.0, 12.0);
        for (Body& body : s.bodies)
        {
          body.colors.component = 2;
          body.colors.isLogarithmic = true;
          body.colors.isMappedLast = true;
        }
      } },
    { "color-table-nan-and-infinity",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Heat", false);
        map(s, 16, 75.0, 130.0);
        std::vector<double>& heat = s.bodies[0].arrays[0].values;
        for (std::size_t k = 0; k < heat.size(); k += 7)
        {
          heat[k] = k % 2 ? std::numeric_limits<double>::quiet_NaN()
                          : std::numeric_limits<double>::infinity();
        }
        s.bodies[0].colors.isMappedLast = true;
      } },
    { "color-spheres",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Heat", false);
        map(s, 16, 75.0, 130.0);
        s.bodies[1].spheres(0.0625);
        s.bodies[1].colors.isMappedLast = true; // nothing is interpolated
      } },
    { "color-transformed",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Paint", false);
        s.bodies[1].colorBy("Shade", true);
        s.bodies[0].place({ -1, 0, 0 }, { 0, 1, 0.25 }, { 0, 0, 1 }, { 0.25, 0, 0 }); // a mirror
        s.bodies[1].place({ 0.5, 0, 0.5 }, { 0, 1.25, 0 }, { -0.5, 0, 0.5 }, { 0, -0.25, 0.25 });
      } },
    { "color-points-samples-3-alpha-scene-ambient",
      [](Stage& s)
      {
        landscape(s);
        colorBy(s, "Paint", false);
        s.samples = 3;
        s.hasAlpha = true;
        s.scene.ambientModel = lambent::AmbientModel::Scene;
        s.scene.twoSidedLighting = false;
        s.showDepth();
        s.showArray("Heat", false);
      } },
  };
}
