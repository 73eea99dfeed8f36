// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a vtkCamera as a camera of the core
 *
 * Reads only plain settings, never the matrices that VTK computes from them: their last bits
 * differ between platforms.
 */
#ifndef CameraFromVTK_h
#define CameraFromVTK_h

#include "Scene.h"

#include <string>

class vtkCamera;

namespace lambent::adapters
{
Camera cameraFromVTK(vtkCamera* camera);

/// Applies to a camera what framing the bounds changes: position, focal point, view-up, view angle
/// and parallel scale.
void applyFraming(const Camera& framed, vtkCamera* camera);

/// The names of the camera's settings that are not supported; empty if none are in use.
std::string unsupportedSettings(vtkCamera* camera);

/// What is wrong with a camera, and the remedy; empty if nothing is wrong.
std::string describeDefect(const Camera& camera);
}

#endif
