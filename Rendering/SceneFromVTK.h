// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's camera, lights and properties as the core's
 *
 * Only plain settings are read, never the matrices that VTK computes from them:
 * those differ in their last bits between platforms.
 */
#ifndef SceneFromVTK_h
#define SceneFromVTK_h

#include "Scene.h"

#include <string>

class vtkCamera;
class vtkLight;
class vtkProperty;

namespace lambent::adapters
{
Camera cameraFromVTK(vtkCamera* camera);

/// Give a camera what framing bounds changes: position, focal point, view-up, view
/// angle and parallel scale.
void applyFraming(const Camera& framed, vtkCamera* camera);

/// What of the camera's settings is not supported; empty if nothing.
std::string unsupportedSettings(vtkCamera* camera);

/// What is wrong with a camera, and the remedy; empty if nothing.
std::string describeDefect(const Camera& camera);

/// A light as seen with a camera. Headlights and camera lights move with it.
Light lightFromVTK(vtkLight* light, const Camera& camera);

/// What is wrong with a light, and the remedy, to follow its name; empty if nothing.
std::string describeDefect(const Light& light);

/// The white headlight of a scene without lights.
Light headlight(const Camera& camera);

/// A property as an appearance; nullptr is the default one.
Appearance appearanceFromVTK(vtkProperty* property);

using lambent::isFinite;
/// False if a coefficient or colour of the appearance is not a finite number.
bool isFinite(const Appearance& appearance);
}

#endif
