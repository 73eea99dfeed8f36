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

/// Why the texture of an option is not shown, with a remedy; empty if it is, or if there is none.
std::string WhyTextureIsIdle(const Options& options);

/// One reason for each, with a remedy. `hasHighlights` tells whether a material has some.
std::vector<std::string> WhyPropertyIsIdle(const Options& options,
  const std::vector<vtkSmartPointer<vtkPolyData>>& meshes, bool hasHighlights);

} // namespace lambent::command

#endif
