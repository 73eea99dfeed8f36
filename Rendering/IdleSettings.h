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

/// Of the camera, the lights, the properties that are in use, and how normals are to be
/// computed.
std::vector<std::string> findIdleSettings(const SceneSettings& settings);
}

#endif
