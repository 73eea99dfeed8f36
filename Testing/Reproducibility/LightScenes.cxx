// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with lights of every kind, on different materials.
#include "Scenes.h"

using lambent::AmbientModel;

namespace
{
/// Hills, lit from above (+z).
Body& land(Stage& s)
{
  s.look({ 1.5, -2.0, 2.5 }, Vec3(0.0), { 0.0, 0.0, 1.0 });
  return s.add(hills(24));
}
}

SceneList lightScenes()
{
  return {
    { "light-none", [](Stage& s) { land(s); } },
    { "light-sun",
      [](Stage& s)
      {
        land(s);
        s.sun({ -3.0, 1.0, -2.0 });
      } },
    { "light-lamp",
      [](Stage& s)
      {
        land(s);
        s.lamp({ 0.5, -0.25, 0.75 });
      } },
    { "light-at-the-eye",
      [](Stage& s)
      {
        land(s);
        s.lamp(s.scene.camera.position);
      } },
    { "light-lamp-on-the-surface",
      [](Stage& s)
      {
        land(s);
        s.lamp(hills(24).points[300]);
      } },
    { "light-cone-hard",
      [](Stage& s)
      {
        land(s);
        s.spot({ 0.5, 0.25, 1.5 }, { -0.25, 0.0, -1.0 }, 25.0, 0.0);
      } },
    { "light-cone-soft",
      [](Stage& s)
      {
        land(s);
        s.spot({ 0.5, 0.25, 1.5 }, { -0.25, 0.0, -1.0 }, 35.0, 12.0);
      } },
    { "light-cone-of-odd-power",
      [](Stage& s)
      {
        land(s);
        s.spot({ 0.5, 0.25, 1.5 }, { -0.25, 0.125, -1.0 }, 61.7, 2.37);
        s.spot({ -0.5, 0.25, 1.25 }, { 0.25, 0.125, -1.0 }, 17.3, 0.31);
      } },
    { "light-cone-of-half-a-space",
      [](Stage& s)
      {
        land(s);
        s.spot({ 0.0, 0.0, 0.125 }, { 1.0, 0.5, 0.0 }, 89.99, 1.0);
      } },
    { "light-attenuated",
      [](Stage& s)
      {
        land(s);
        s.lamp({ 0.5, -0.25, 0.75 }).attenuation = { 0.5, 0.3, 0.0 };
      } },
    { "light-attenuated-by-the-square",
      [](Stage& s)
      {
        land(s);
        s.lamp({ 0.5, -0.25, 0.75 }).attenuation = { 0.0, 0.1, 2.3 };
      } },
    { "light-cone-attenuated",
      [](Stage& s)
      {
        land(s);
        s.spot({ 0.5, 0.25, 1.5 }, { -0.25, 0.0, -1.0 }, 40.0, 3.0).attenuation = { 0.2, 0.3, 0.4 };
      } },
    { "light-twelve",
      [](Stage& s)
      {
        land(s);
        RandomNumbers random(12);
        for (int k = 0; k < 12; ++k)
        {
          const Vec3 place = random.inBox(2.0), color = (random.inBox(0.5) + Vec3(0.5)) * 0.25;
          k % 2 ? s.lamp(place, color) : s.sun(-place, color);
        }
      } },
    { "light-too-bright-and-negative",
      [](Stage& s)
      {
        land(s);
        s.sun({ -3.0, 1.0, -2.0 }, { 3.0, 1.5, 0.5 });
        s.sun({ 3.0, 1.0, -2.0 }, { -0.5, 0.25, -2.0 });
      } },
    { "light-of-intensity-0",
      [](Stage& s)
      {
        land(s);
        s.sun({ -3.0, 1.0, -2.0 });
        s.lamp({ 0.5, -0.25, 0.75 }, Vec3(0.0));
      } },
    { "light-faint",
      [](Stage& s)
      {
        land(s);
        s.lamp({ 0.5, -0.25, 0.75 }, { 1e-30, 1e-3, 1e-300 });
      } },
    { "light-ambient-per-light",
      [](Stage& s)
      {
        land(s).paint({ 0.5, 0.6, 0.7 }, { 0.3, 0.2, 0.1 });
        s.daylight();
      } },
    { "light-ambient-once",
      [](Stage& s)
      {
        land(s).paint({ 0.5, 0.6, 0.7 }, { 0.3, 0.2, 0.1 });
        s.daylight();
        s.scene.ambientModel = AmbientModel::Scene;
      } },
    { "light-ambient-alone",
      [](Stage& s)
      {
        land(s).paint(Vec3(0.0), { 0.3, 0.2, 0.1 });
        s.scene.ambientModel = AmbientModel::Scene;
      } },
    { "light-one-sided",
      [](Stage& s)
      {
        s.scene.twoSidedLighting = false;
        s.daylight();
        s.add(hills(16));
        s.add(moved(cylinder(4), { 0.25, 0.5, -0.25 })).flat().paint({ 0.4, 0.8, 0.3 });
        s.look({ 0.5, 3.5, -2.5 }, Vec3(0.0));
      } },
  };
}
