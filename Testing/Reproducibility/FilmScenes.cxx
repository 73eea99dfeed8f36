// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Alpha and background images.
#include "Scenes.h"

using lambent::AttributeType;

namespace
{
void transparent(Stage& s, int samples)
{
  s.hasAlpha = true;
  ballAndBox(s, samples);
}

void before(Stage& s, int samples, int width, int height, int components, AttributeType type)
{
  ballAndBox(s, samples);
  s.imageBehind(width, height, components, type);
  s.scene.background = { 0.1, 0.2, 0.3 };
  s.scene.backgroundTop = { 0.7, 0.5, 0.2 };
}
}

SceneList filmScenes()
{
  return {
    { "alpha", [](Stage& s) { transparent(s, 1); } },
    { "alpha-samples-3", [](Stage& s) { transparent(s, 3); } },
    { "alpha-samples-4-unlit",
      [](Stage& s)
      {
        s.hasAlpha = true;
        s.samples = 4;
        s.add(ball(2)).unlit().paint({ 0.25, 0.5, 1.0 });
        s.size(67, 41);
      } },
    { "alpha-of-nothing", [](Stage& s) { s.hasAlpha = true; } },
    { "background-image", [](Stage& s) { before(s, 1, 96, 72, 3, AttributeType::UInt8); } },
    { "background-image-small", [](Stage& s) { before(s, 1, 7, 5, 3, AttributeType::UInt8); } },
    { "background-image-large-grey",
      [](Stage& s) { before(s, 2, 131, 257, 1, AttributeType::Float); } },
    { "background-image-alpha-samples-3",
      [](Stage& s) { before(s, 3, 33, 20, 4, AttributeType::Float); } },
    { "background-image-grey-and-alpha",
      [](Stage& s) { before(s, 1, 20, 33, 2, AttributeType::UInt8); } },
  };
}
