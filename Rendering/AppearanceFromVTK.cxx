// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AppearanceFromVTK.h"

#include "Vec3FromVTK.h"

#include "vtkProperty.h"

#include <cmath>

namespace lambent::adapters
{
Appearance appearanceFromVTK(vtkProperty* property)
{
  Appearance result;
  if (!property)
  {
    return result;
  }
  result.diffuse = property->GetDiffuse();
  result.ambient = property->GetAmbient();
  result.diffuseColor = vec3FromVTK(property->GetDiffuseColor());
  result.ambientColor = vec3FromVTK(property->GetAmbientColor());
  result.opacity = property->GetOpacity();
  result.shading = !property->GetLighting()    ? Shading::Unlit
    : property->GetInterpolation() == VTK_FLAT ? Shading::Flat
                                               : Shading::Smooth;
  result.cullFront = property->GetFrontfaceCulling() != 0;
  result.cullBack = property->GetBackfaceCulling() != 0;
  return result;
}

std::string describeDefect(const Appearance& appearance)
{
  if (!std::isfinite(appearance.opacity))
  {
    return "has an opacity that is not a finite number. Call SetOpacity() with 0 to 1.";
  }
  if (isFinite(appearance.diffuseColor) && isFinite(appearance.diffuseReflection()) &&
    isFinite(appearance.ambientReflection()))
  {
    return "";
  }
  return "has a colour or coefficient that is not a finite number. Call SetColor(), SetDiffuse() "
         "and SetAmbient() with finite ones.";
}
}
