// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the scenes whose pictures must be the same bits everywhere
 *
 * To add one, write an entry in the file that it belongs to, and take its hashes into
 * the list with `scenes.py --update` (see there).
 */
#ifndef Scenes_h
#define Scenes_h

#include "Stage.h"

#include <functional>
#include <string>

struct SceneEntry
{
  std::string name; ///< of its files, too
  std::function<void(Stage&)> build;
};

using SceneList = std::vector<SceneEntry>;

SceneList viewScenes();
SceneList sampleScenes();
SceneList lightScenes();
SceneList surfaceScenes();
SceneList crowdScenes();
SceneList hostileScenes();

/// All of these.
SceneList allScenes();

#endif
