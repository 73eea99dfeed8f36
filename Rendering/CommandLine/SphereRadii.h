// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief draws the points of the inputs as spheres, for `--spheres`
 *
 * With a radius only, all inputs become spheres. With an array, the inputs that have it do.
 */

#ifndef SphereRadii_h
#define SphereRadii_h

#include "DataValues.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkLambentRayTracer;
class vtkPolyData;

namespace lambent::command
{

/// Throws WrongUsage if no input has the point array (the message lists those that exist), or if it
/// does not have one finite number of 0 or more per point.
void CheckSpheres(
  const SpheresValue& spheres, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

void SetSpheres(
  const SpheresValue& spheres, vtkPolyData* mesh, int connection, vtkLambentRayTracer* tracer);

} // namespace lambent::command

#endif
