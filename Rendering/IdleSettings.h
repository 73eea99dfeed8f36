// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief settings that were changed from their defaults and have no effect
 *
 * Each message names the setting and what to do instead.
 */
#ifndef IdleSettings_h
#define IdleSettings_h

#include <string>
#include <vector>

namespace lambent::adapters
{
struct SceneSettings;

/// Checks the camera, the lights, the properties in use, the settings for computing normals, the
/// background, and the arrays to pass.
/// Returns one message for each setting without effect.
std::vector<std::string> findIdleSettings(const SceneSettings& settings);
}

#endif
