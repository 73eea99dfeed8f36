// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief why --feature-angle has no effect on a scene
 *
 * The angle matters only where normals are computed: for smooth shading of meshes without normals.
 */

#ifndef IdleFeatureAngle_h
#define IdleFeatureAngle_h

#include "Options.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace lambent::command
{

/// The reason and the remedy in one line. Empty if the angle has an effect or is not given, or if
/// there is nothing to draw.
std::string WhyFeatureAngleIsIdle(
  const Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

} // namespace lambent::command

#endif
