// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IdleSettings.h"

#include "SceneFromVTK.h"
#include "vtkLambentRayTracer.h"

#include "vtkCollectionRange.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"

namespace
{
using Messages = std::vector<std::string>;

/// `whose` begins the message.
void addProperty(Messages& messages, const std::string& whose, vtkProperty* property)
{
  const auto add = [&](bool isSet, const char* text)
  {
    if (isSet)
    {
      messages.push_back(whose + " vtkProperty::" + text);
    }
  };
  add(property->GetRepresentation() == VTK_WIREFRAME,
    "SetRepresentationToWireframe() has no effect; faces are drawn filled. Make tubes of the "
    "edges, "
    "with vtkExtractEdges and vtkTubeFilter.");
  add(property->GetRepresentation() == VTK_POINTS,
    "SetRepresentationToPoints() has no effect; faces are drawn filled. Make spheres of the "
    "points, "
    "with vtkGlyph3D.");
  add(property->GetOpacity() != 1.0,
    "SetOpacity() has no effect; every surface is opaque. Set it back to 1, or remove the input.");
  add(property->GetEdgeVisibility() != 0,
    "EdgeVisibilityOn() has no effect. Make tubes of the edges, with vtkExtractEdges and "
    "vtkTubeFilter, as a further input.");
  add(property->GetVertexVisibility() != 0,
    "VertexVisibilityOn() has no effect. Make spheres of the points, with vtkGlyph3D, as a further "
    "input.");
  add(property->GetSpecular() != 0.0,
    "SetSpecular() has no effect; there are no highlights. Set it back to 0.");
  add(property->GetInterpolation() == VTK_PBR,
    "SetInterpolationToPBR() has no effect but smooth shading. Call SetInterpolationToPhong().");
  add(property->GetNumberOfTextures() > 0,
    "SetTexture() has no effect. Call SetColor(), and RemoveAllTextures().");
}

void addProperties(Messages& messages, vtkLambentRayTracer* filter)
{
  bool isCommonUsed = false;
  for (int k = 0; k < filter->GetNumberOfInputConnections(0); ++k)
  {
    vtkProperty* const own = filter->GetInputProperty(k);
    isCommonUsed = isCommonUsed || !own;
    if (own)
    {
      addProperty(messages, "Input " + std::to_string(k) + ":", own);
    }
  }
  if (isCommonUsed && filter->GetProperty())
  {
    addProperty(messages, "The property of all inputs:", filter->GetProperty());
  }
}

/// A light that shines along the way to its focal point, and stands there.
bool isWithoutDirection(vtkLight* light)
{
  const double *from = light->GetPosition(), *to = light->GetFocalPoint();
  const bool isAimed = !light->GetPositional() || light->GetConeAngle() < 90.0;
  return !light->LightTypeIsHeadlight() && isAimed && from[0] == to[0] && from[1] == to[1] &&
    from[2] == to[2];
}

void addLights(Messages& messages, vtkLambentRayTracer* filter)
{
  int index = 0;
  for (vtkLight* light : vtk::Range(filter->GetLights()))
  {
    if (light->GetSwitch() && isWithoutDirection(light))
    {
      messages.push_back("Light " + std::to_string(index) +
        " gives no diffuse light: it stands at its own focal point, so that it shines in no "
        "direction. Call "
        "vtkLight::SetPosition() or SetFocalPoint().");
    }
    ++index;
  }
}
}

std::vector<std::string> findIdleSettings(vtkLambentRayTracer* filter)
{
  Messages messages;
  if (filter->GetCamera())
  {
    const std::string names = unsupportedSettings(filter->GetCamera());
    if (!names.empty())
    {
      messages.push_back(
        "The camera has settings that are not supported and are ignored: " + names + ".");
    }
  }
  addProperties(messages, filter);
  addLights(messages, filter);
  return messages;
}
