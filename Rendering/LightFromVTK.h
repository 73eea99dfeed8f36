// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a vtkLight as a light of the core
 *
 * Reads only plain settings, never the matrices that VTK computes from them: their last bits
 * differ between platforms.
 */
#ifndef LightFromVTK_h
#define LightFromVTK_h

#include "Scene.h"

#include <string>

class vtkLight;

namespace lambent::adapters
{
/// The light in the scene that a camera shows. Headlights and camera lights move with the camera.
Light lightFromVTK(vtkLight* light, const Camera& camera);

/// What is wrong with a light, and the remedy; the message goes after its name. Empty if nothing is
/// wrong.
std::string describeDefect(const Light& light);

/// The white headlight of a scene without lights.
Light headlight(const Camera& camera);
}

#endif
