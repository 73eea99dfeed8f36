// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's camera as the core's
 *
 * Only plain settings are read, never the matrices that VTK computes from them:
 * those differ in their last bits between platforms.
 */
#ifndef CameraFromVTK_h
#define CameraFromVTK_h

#include "Scene.h"

#include <string>

class vtkCamera;

namespace lambent::adapters
{
Camera cameraFromVTK(vtkCamera* camera);

/// Give a camera what framing bounds changes: position, focal point, view-up, view
/// angle and parallel scale.
void applyFraming(const Camera& framed, vtkCamera* camera);

/// Which of the camera's settings are not supported; empty if none.
std::string unsupportedSettings(vtkCamera* camera);

/// What is wrong with a camera, and the remedy; empty if nothing.
std::string describeDefect(const Camera& camera);
}

#endif
