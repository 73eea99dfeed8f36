// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with different cameras, image sizes and backgrounds.
#include "Scenes.h"

namespace
{
/// A ball and a box to look at.
void still(Stage& s)
{
  s.daylight();
  s.add(ball(3)).round();
  s.add(moved(box({ 0.5, 0.75, 0.25 }), { 1.0625, -0.5, 0.75 })).flat().paint({ 0.3, 0.6, 0.9 });
}
}

SceneList viewScenes()
{
  return {
    { "view-perspective", [](Stage& s) { still(s); } },
    { "view-parallel",
      [](Stage& s)
      {
        still(s);
        s.lookParallel(1.625);
      } },
    { "view-wide-angle",
      [](Stage& s)
      {
        still(s);
        s.look({ 0.75, 0.5, 1.5 }, Vec3(0.0));
        s.scene.camera.viewAngle = 140.0;
      } },
    { "view-narrow-angle",
      [](Stage& s)
      {
        still(s);
        s.look(s.scene.camera.position, { 1.5625, 0.25, 1.0 }); // at a corner of the box
        s.scene.camera.viewAngle = 0.01;
      } },
    { "view-horizontal-angle",
      [](Stage& s)
      {
        still(s);
        s.scene.camera.horizontalViewAngle = true;
        s.scene.camera.viewAngle = 37.5;
      } },
    { "view-window-centre",
      [](Stage& s)
      {
        still(s);
        s.scene.camera.windowCenter[0] = 0.3;
        s.scene.camera.windowCenter[1] = -0.7;
      } },
    { "view-rolled",
      [](Stage& s)
      {
        still(s);
        s.look({ -3.0, 2.0, 3.5 }, { 0.1, 0.2, 0.3 }, { 0.6, 0.8, 0.0 });
      } },
    { "view-from-above",
      [](Stage& s)
      {
        still(s);
        s.look({ 0.0, 5.0, 0.0 }, Vec3(0.0), { 0.0, 0.0, -1.0 });
      } },
    { "view-from-inside",
      [](Stage& s)
      {
        s.daylight();
        s.add(ball(4)).round();
        s.look({ 0.2, 0.1, -0.3 }, { 0.5, 0.4, 0.3 });
        s.scene.camera.viewAngle = 95.0;
      } },
    { "view-from-within-parallel",
      [](Stage& s)
      {
        s.daylight();
        s.add(ball(3));
        s.look({ 0.0, 0.125, 0.0 }, { 1.0, 0.5, 0.25 });
        s.lookParallel(1.25);
      } },
    { "view-framed",
      [](Stage& s)
      {
        still(s);
        s.isFramed = true;
      } },
    { "view-tall",
      [](Stage& s)
      {
        still(s);
        s.size(13, 131);
      } },
    { "view-flat-image",
      [](Stage& s)
      {
        still(s);
        s.size(259, 7);
      } },
    { "view-one-column",
      [](Stage& s)
      {
        still(s);
        s.size(1, 97);
      } },
    { "view-one-pixel",
      [](Stage& s)
      {
        still(s);
        s.size(1, 1);
      } },
    { "view-odd-size",
      [](Stage& s)
      {
        still(s);
        s.size(67, 61);
      } },
    { "view-gradient-of-nothing",
      [](Stage& s)
      {
        s.scene.background = { 0.9, 0.1, -0.25 };
        s.scene.backgroundTop = { 0.1, 1.5, 0.3 };
      } },
    { "view-gradient",
      [](Stage& s)
      {
        still(s);
        s.scene.background = { 0.8, 0.75, 0.6 };
        s.scene.backgroundTop = { 0.2, 0.4, 0.9 };
      } },
  };
}
