// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief settings of VTK's objects that were changed from their defaults and have no effect
 *
 * Each message names the setting and what to do instead.
 */
#ifndef IdleSettings_h
#define IdleSettings_h

#include <string>
#include <vector>

class vtkLambentRayTracer;

/// Of the camera, the lights and the properties that are in use.
std::vector<std::string> findIdleSettings(vtkLambentRayTracer* filter);

#endif
