// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "AppearanceFromVTK.h"

#include "EdgesFromVTK.h"
#include "Vec3FromVTK.h"

#include "vtkProperty.h"

#include <cmath>

namespace lambent::adapters
{
namespace
{
bool isFinite(const EdgeStyle& style)
{
  return lambent::isFinite(style.color) && std::isfinite(style.opacity) &&
    std::isfinite(style.width);
}

bool isFinite(const SpecularStyle& style)
{
  return lambent::isFinite(style.color) && std::isfinite(style.coefficient) &&
    std::isfinite(style.power) && lambent::isFinite(style.reflection());
}

std::string describeDefect(const SpecularStyle& style)
{
  if (!isFinite(style))
  {
    return "has a specular setting that is not a finite number. Call SetSpecular(), "
           "SetSpecularColor() and SetSpecularPower() with finite ones.";
  }
  if (style.power < 0.0)
  {
    return "has a specular power below 0. Call SetSpecularPower() with 0 or more.";
  }
  return "";
}
}

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
  result.edges = edgesFromVTK(property);
  result.specular.coefficient = property->GetSpecular();
  result.specular.color = vec3FromVTK(property->GetSpecularColor());
  result.specular.power = property->GetSpecularPower();
  return result;
}

std::string describeDefect(const Appearance& appearance)
{
  if (!std::isfinite(appearance.opacity))
  {
    return "has an opacity that is not a finite number. Call SetOpacity() with 0 to 1.";
  }
  if (!lambent::isFinite(appearance.diffuseColor) ||
    !lambent::isFinite(appearance.diffuseReflection()) ||
    !lambent::isFinite(appearance.ambientReflection()))
  {
    return "has a colour or coefficient that is not a finite number. Call SetColor(), "
           "SetDiffuse() and SetAmbient() with finite ones.";
  }
  if (appearance.edges.areVisible && !isFinite(appearance.edges))
  {
    return "has an edge colour, edge opacity or line width that is not a finite number. Call "
           "SetEdgeColor(), SetEdgeOpacity() and SetLineWidth() with finite ones, or "
           "EdgeVisibilityOff().";
  }
  return appearance.isShiny() ? describeDefect(appearance.specular) : "";
}
}
