// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's lights as the core's
 *
 * Only plain settings are read, never the matrices that VTK computes from them:
 * those differ in their last bits between platforms.
 */
#ifndef LightFromVTK_h
#define LightFromVTK_h

#include "Scene.h"

#include <string>

class vtkLight;

namespace lambent::adapters
{
/// A light as seen with a camera. Headlights and camera lights move with it.
Light lightFromVTK(vtkLight* light, const Camera& camera);

/// What is wrong with a light, and the remedy, to follow its name; empty if nothing.
std::string describeDefect(const Light& light);

/// The white headlight of a scene without lights.
Light headlight(const Camera& camera);
}

#endif
