// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SphereRadii.h"
#include "InputArrays.h"
#include "Messages.h"

#include "vtkLambentRayTracer.h"

#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <cmath>
#include <sstream>

namespace lambent::command
{
namespace
{

using Association = PassValue::Association;

void CheckRadii(const std::string& name, vtkDataArray* radii)
{
  if (radii->GetNumberOfComponents() != 1)
  {
    throw WrongUsage("--spheres " + name + ": the array has " +
      std::to_string(radii->GetNumberOfComponents()) +
      " components, but a radius is one number; choose another array, or a number");
  }
  for (vtkIdType k = 0; k < radii->GetNumberOfTuples(); ++k)
  {
    const double radius = radii->GetComponent(k, 0);
    if (!(radius >= 0) || !std::isfinite(radius))
    {
      std::ostringstream text;
      text << "--spheres " << name << ": point " << k << " has the value " << radius
           << ", but a radius is a finite number of 0 or more; choose another array, or a number";
      throw WrongUsage(text.str());
    }
  }
}

} // namespace

void CheckSpheres(
  const SpheresValue& spheres, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes)
{
  const std::string& name = spheres.array;
  if (!name.empty() && !HasArray(meshes, Association::Points, name))
  {
    ArrayList list;
    list.association = Association::Points;
    list.nearest = name;
    throw WrongUsage("--spheres " + name +
      ": no input has such a point array; write a radius or one of: " + ListArrays(meshes, list));
  }
  for (vtkPolyData* const mesh : meshes)
  {
    if (vtkDataArray* const radii =
          name.empty() ? nullptr : ArrayOf(mesh, Association::Points, name))
    {
      CheckRadii(name, radii);
    }
  }
}

void SetSpheres(
  const SpheresValue& spheres, vtkPolyData* mesh, int connection, vtkLambentRayTracer* tracer)
{
  if (spheres.array.empty())
  {
    tracer->SetInputSphereRadius(connection, spheres.radius);
  }
  else if (ArrayOf(mesh, Association::Points, spheres.array))
  {
    tracer->SetInputSphereRadius(connection, spheres.radius);
    tracer->SetInputSphereRadiusArray(connection, spheres.array.c_str());
  }
}

} // namespace lambent::command
