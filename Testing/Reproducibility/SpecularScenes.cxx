// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Highlights.
#include "Scenes.h"

using lambent::AttributeType;

namespace
{
Body& shiny(Body& body, double power, double coefficient = 0.75, const Vec3& color = Vec3(1.0))
{
  body.appearance.specular.power = power;
  body.appearance.specular.coefficient = coefficient;
  body.appearance.specular.color = color;
  return body;
}

/// A shiny ball on a less shiny, hilly ground.
void ballOnGround(Stage& s)
{
  s.daylight();
  s.scene.lights[1].specularColor = { 0.5, 0.75, 1.0 };
  shiny(s.add(ball(3)).round(), 20.0);
  shiny(s.add(moved(hills(12), { 0.0, 0.0, -1.0 })), 3.0, 0.5, { 1.0, 0.75, 0.5 });
}
}

SceneList specularScenes()
{
  return {
    { "specular-ball", ballOnGround },
    { "specular-powers",
      [](Stage& s)
      {
        s.daylight();
        const double powers[] = { 0.0, 0.5, 1.0, 2.5, 128.0 };
        for (int k = 0; k < 5; ++k)
        {
          const Vec3 place(0.75 * k - 1.5, 0.0, 0.25 * k - 0.5);
          shiny(s.add(moved(scaled(ball(2), Vec3(0.375)), place)), powers[k]);
        }
      } },
    { "specular-parallel",
      [](Stage& s)
      {
        ballOnGround(s);
        s.lookParallel(1.5);
      } },
    { "specular-spots",
      [](Stage& s)
      {
        s.spot({ 0.5, 1.0, 3.0 }, { -0.25, -0.5, -2.0 }, 25.0, 3.5).specularColor = { 1.0, 0.5,
          0.25 };
        lambent::Light& lamp = s.lamp({ -1.0, 2.0, 1.5 });
        lamp.attenuation = { 0.25, 0.125, 0.5 };
        shiny(s.add(ball(3)).round(), 8.0);
      } },
    { "specular-spheres",
      [](Stage& s)
      {
        s.daylight();
        shiny(s.add(ball(1)).spheres(0.375), 30.0);
      } },
    { "specular-flat-of-some-unlit",
      [](Stage& s)
      {
        s.daylight();
        shiny(s.add(ball(2)).flat(), 5.0);
        shiny(s.add(moved(ball(2), { 1.25, 0.5, 0.0 })).unlit(), 5.0);
        s.add(moved(ball(2), { -1.25, -0.5, 0.0 }));
      } },
    { "specular-colors",
      [](Stage& s)
      {
        ballOnGround(s);
        for (Body& body : s.bodies)
        {
          body.flat();
          body.pointArray("Paint", 3, AttributeType::UInt8);
          body.cellArray("Shade", 4, AttributeType::UInt8);
        }
        s.bodies[0].colorBy("Paint", false);
        s.bodies[1].colorBy("Shade", true).hasAlpha = true;
      } },
    { "specular-one-sided-scene-ambient",
      [](Stage& s)
      {
        ballOnGround(s);
        s.scene.twoSidedLighting = false;
        s.scene.ambientModel = lambent::AmbientModel::Scene;
        s.look({ 1.5, 3.0, -2.5 }, Vec3(0.0));
      } },
    { "specular-samples-2-alpha-passes",
      [](Stage& s)
      {
        ballOnGround(s);
        s.samples = 2;
        s.hasAlpha = true;
        s.showNormals();
        s.showPositions();
      } },
    { "specular-edges",
      [](Stage& s)
      {
        ballOnGround(s);
        s.bodies[0].appearance.edges.areVisible = true;
        s.showDepth();
      } },
    { "specular-far-from-the-origin",
      [](Stage& s)
      {
        const Vec3 offset(5e6, -5e6, 5e6);
        s.look(offset + Vec3(2.0, 1.5, 4.0), offset);
        s.sun({ -1.0, -2.0, -1.5 });
        shiny(s.add(moved(ball(3), offset)).flat(), 12.0);
      } },
  };
}
