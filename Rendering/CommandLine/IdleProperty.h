// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief why options of the surfaces' property have no effect
 */

#ifndef IdleProperty_h
#define IdleProperty_h

#include "Options.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace lambent::command
{

/// Whether all inputs are drawn as spheres.
bool AreAllSpheres(const Options& options);

/// One reason for each, with a remedy. An option that has its default value is never named.
std::vector<std::string> WhyPropertyIsIdle(
  const Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

} // namespace lambent::command

#endif
