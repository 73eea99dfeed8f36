// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Scenes with several samples per pixel.
#include "Scenes.h"

namespace
{
/// On a gradient.
void still(Stage& s, int samples)
{
  ballAndBox(s, samples);
  s.scene.background = { 0.1, 0.2, 0.3 };
  s.scene.backgroundTop = { 0.7, 0.5, 0.2 };
}
}

SceneList sampleScenes()
{
  return {
    { "samples-2", [](Stage& s) { still(s, 2); } },
    { "samples-3", [](Stage& s) { still(s, 3); } },
    { "samples-4-parallel",
      [](Stage& s)
      {
        still(s, 4);
        s.lookParallel(1.625);
      } },
    { "samples-5-odd-size",
      [](Stage& s)
      {
        still(s, 5);
        s.size(67, 41);
      } },
    { "samples-16",
      [](Stage& s)
      {
        still(s, 16);
        s.size(33, 25);
      } },
    { "samples-3-unlit",
      [](Stage& s)
      {
        s.samples = 3;
        s.add(ball(2)).unlit().paint({ 0.25, 0.5, 1.0 });
        s.add(moved(ball(2), { 0.5, 0.25, 0.5 })).flat().paint({ 1.0, 0.5, 0.25 });
        s.daylight();
      } },
  };
}
