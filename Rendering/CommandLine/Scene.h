// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief from options to a ray tracer that is ready to be updated
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

/// Camera, lights, property and image of the options, over the meshes.
vtkSmartPointer<vtkLambentRayTracer> MakeScene(
  const Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

} // namespace lambent::command

#endif
