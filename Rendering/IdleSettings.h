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

class vtkLambentRayTracer;
class vtkPolyData;

namespace lambent::adapters
{
/// Of the camera, the lights, the properties that are in use, and how the filter is to compute
/// normals. An input for each connection.
std::vector<std::string> findIdleSettings(
  vtkLambentRayTracer* filter, const std::vector<vtkPolyData*>& inputs);
}

#endif
