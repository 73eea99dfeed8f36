// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Transparent surfaces: layers of every sample, from the nearest to the farthest.
#include "Scenes.h"

using lambent::AttributeType;
using lambent::PassContent;

namespace
{
/// Two balls in each other, and a sheet that cuts both.
void glasses(Stage& s)
{
  s.daylight();
  s.scene.background = { 0.25, 0.25, 0.5 };
  s.scene.backgroundTop = { 0.75, 0.75, 1.0 };
  s.add(ball(3)).round().paint({ 0.9, 0.3, 0.2 }).appearance.opacity = 0.5;
  s.add(scaled(ball(2), Vec3(0.5))).round().paint({ 0.2, 0.8, 0.4 }).appearance.opacity = 0.25;
  s.add(hills(10)).flat().paint({ 0.9, 0.8, 0.3 }).appearance.opacity = 0.75;
}

/// Sheets one behind the other.
void stack(Stage& s, int count, double opacity)
{
  s.scene.background = s.scene.backgroundTop = Vec3(1.0);
  for (int k = 0; k < count; ++k)
  {
    const double share = (k * 7 % count) / double(count);
    Body& sheet = s.add(moved(box({ 1.0, 1.0, 0.0 }), { 0.25 * share, 0.0, 0.5 - share }));
    sheet.unlit().paint({ share, 0.5, 1.0 - share }).appearance.opacity = opacity;
  }
}

/// Bytes whose last component is alpha.
void paintWithAlpha(Body& body, bool isPerCell)
{
  isPerCell ? body.cellArray("Paint", 4, AttributeType::UInt8)
            : body.pointArray("Paint", 4, AttributeType::UInt8);
  body.colorBy("Paint", isPerCell).hasAlpha = true;
}
}

SceneList transparencyScenes()
{
  return {
    { "transparency-in-each-other", [](Stage& s) { glasses(s); } },
    { "transparency-samples-2-alpha",
      [](Stage& s)
      {
        glasses(s);
        s.samples = 2;
        s.hasAlpha = true;
      } },
    { "transparency-among-opaque",
      [](Stage& s)
      {
        ballAndBox(s, 1);
        s.add(scaled(ball(2), Vec3(1.5))).appearance.opacity = 0.375;
        s.add(moved(box({ 0.25, 0.25, 0.25 }), { 0.0, 1.25, 0.0 })).appearance.opacity = 0.0;
      } },
    { "transparency-forty-layers", [](Stage& s) { stack(s, 40, 0.0625); } },
    { "transparency-parallel-passes",
      [](Stage& s)
      {
        glasses(s);
        s.lookParallel(1.25);
        s.bodies[0].appearance.opacity = 0.0; // not seen
        s.passes = { { PassContent::Depth, "Depth", false },
          { PassContent::Normal, "Normals", false } };
      } },
    { "transparency-of-points",
      [](Stage& s)
      {
        glasses(s);
        paintWithAlpha(s.bodies[0], false);
        paintWithAlpha(s.bodies[2], false);
        s.bodies[2].appearance.opacity = 1.0;
      } },
    { "transparency-of-cells",
      [](Stage& s)
      {
        glasses(s);
        paintWithAlpha(s.bodies[0], true);
        paintWithAlpha(s.bodies[2], true);
        s.bodies[2].unlit();
      } },
    { "transparency-of-a-table",
      [](Stage& s)
      {
        glasses(s);
        for (Body& body : s.bodies)
        {
          body.pointArray("Heat", 1, AttributeType::Float);
          StageColors& colors = body.colorBy("Heat", false);
          for (int k = 0; k < 4 * 12; ++k)
          {
            colors.entries.push_back(static_cast<unsigned char>(k * 89 % 256));
          }
          colors.low = 75.0;
          colors.high = 130.0;
          colors.hasAlpha = true;
        }
        s.bodies[1].colors.isMappedLast = true;
      } },
    { "transparency-spheres",
      [](Stage& s)
      {
        glasses(s);
        RandomNumbers random(31);
        Shape points;
        for (int k = 0; k < 40; ++k)
        {
          points.points.push_back(random.inBox(1.0));
        }
        Body& bubbles = s.add(points).spheres(0.375);
        bubbles.appearance.opacity = 0.5;
        paintWithAlpha(bubbles, false);
        s.add(points).spheres(0.0625).paint({ 0.1, 0.1, 0.1 });
      } },
    { "transparency-edges-on-rays",
      [](Stage& s)
      {
        s.lookParallel(36.0); // a pixel is a unit
        s.look({ 0.5, 0.5, 9.0 }, { 0.5, 0.5, 0.0 });
        s.add(box({ 24.0, 24.0, 0.0 })).unlit().appearance.opacity = 0.5;
      } },
    { "transparency-blocks",
      [](Stage& s)
      {
        s.daylight();
        for (int k = 0; k < 3; ++k)
        {
          Body& body = s.add(moved(ball(2), { 0.5 * k - 0.5, 0.0, 0.0 })).inBlock({ k });
          body.blockOpacity = 0.25 + 0.375 * k;
          body.blockColor = Vec3(0.3 * k, 0.9 - 0.3 * k, 0.25);
        }
      } },
  };
}
