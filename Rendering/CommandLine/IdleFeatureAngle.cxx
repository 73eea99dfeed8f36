// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "IdleFeatureAngle.h"

#include "CheckPolygons.h"
#include "IdleProperty.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace lambent::command
{

std::string WhyFeatureAngleIsIdle(
  const Options& options, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes)
{
  if (!options.featureAngle)
  {
    return "";
  }
  const std::string noEffect = "--feature-angle has no effect";
  if (options.shading != Shading::Smooth)
  {
    return noEffect + " with --shading " + (options.shading == Shading::Flat ? "flat" : "unlit") +
      "; omit one of them";
  }
  if (AreAllSpheres(options))
  {
    return noEffect + " with --spheres; omit one of them";
  }
  if (options.representation != Representation::Surface)
  {
    return noEffect + " with --representation " +
      (options.representation == Representation::Points ? "points" : "wireframe") +
      "; omit one of them";
  }
  bool isAnyDrawn = false;
  for (vtkPolyData* mesh : meshes)
  {
    if (CountTriangles(mesh) == 0)
    {
      continue;
    }
    if (!mesh->GetPointData()->GetNormals())
    {
      return "";
    }
    isAnyDrawn = true;
  }
  return !isAnyDrawn ? ""
    : options.contour
    ? noEffect + ": the contour has its own normals, from the array's gradient; omit it"
    : noEffect +
      ": all meshes have point normals; omit it, or remove the normals from the "
      "files";
}

} // namespace lambent::command
