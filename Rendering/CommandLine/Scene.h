// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief sets up a ray tracer from the options
 */

#ifndef Scene_h
#define Scene_h

#include "Options.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkLambentRayTracer;
class vtkPolyData;

namespace lambent::command
{

/// Returns a ray tracer with the meshes, and the camera, lights, property and image settings of the
/// options, but without the background image and the passes.
vtkSmartPointer<vtkLambentRayTracer> MakeScene(
  const Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

} // namespace lambent::command

#endif
