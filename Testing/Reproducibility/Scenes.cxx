// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

SceneList allScenes()
{
  SceneList all;
  for (const SceneList& scenes :
    { viewScenes(), sampleScenes(), filmScenes(), passScenes(), colorScenes(), lightScenes(),
      surfaceScenes(), edgeScenes(), specularScenes(), inputScenes(), crowdScenes(), sphereScenes(),
      lineScenes(), textureScenes(), transparencyScenes(), hostileScenes() })
  {
    all.insert(all.end(), scenes.begin(), scenes.end());
  }
  return all;
}

void ballAndBox(Stage& s, int samples)
{
  s.samples = samples;
  s.daylight();
  s.add(ball(3)).round();
  s.add(moved(box({ 0.5, 0.75, 0.25 }), { 1.0625, -0.5, 0.75 })).flat().paint({ 0.3, 0.6, 0.9 });
}
