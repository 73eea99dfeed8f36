// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

SceneList allScenes()
{
  SceneList all;
  for (const SceneList& scenes : { viewScenes(), sampleScenes(), filmScenes(), passScenes(),
         lightScenes(), surfaceScenes(), crowdScenes(), hostileScenes() })
  {
    all.insert(all.end(), scenes.begin(), scenes.end());
  }
  return all;
}
