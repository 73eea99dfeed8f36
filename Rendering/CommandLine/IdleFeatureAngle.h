// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief why --feature-angle has no effect on a scene
 *
 * It counts where normals are computed: for meshes that have none, if they are shaded smooth.
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

/// One line: the reason, and what to do; empty if the angle has an effect or is not given, or if
/// there is nothing to draw.
std::string WhyFeatureAngleIsIdle(
  const Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

} // namespace lambent::command

#endif
