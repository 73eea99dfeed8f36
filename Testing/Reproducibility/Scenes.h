// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the scenes whose pictures must have the same bits everywhere
 *
 * To add one, write an entry in the appropriate file, and add its hashes to the list with
 * `scenes.py --update`.
 */
#ifndef Scenes_h
#define Scenes_h

#include "Stage.h"

#include <functional>
#include <string>

struct SceneEntry
{
  std::string name; ///< also of its files
  std::function<void(Stage&)> build;
};

using SceneList = std::vector<SceneEntry>;

SceneList viewScenes();
SceneList sampleScenes();
SceneList filmScenes();
SceneList passScenes();
SceneList colorScenes();
SceneList lightScenes();
SceneList surfaceScenes();
SceneList edgeScenes();
SceneList specularScenes();
SceneList inputScenes();
SceneList crowdScenes();
SceneList sphereScenes();
SceneList transparencyScenes();
SceneList textureScenes();
SceneList lineScenes();
SceneList hostileScenes();

/// All scenes of these lists.
SceneList allScenes();

/// Adds daylight, and a ball in front of a box of another colour.
void ballAndBox(Stage& s, int samples);

#endif
