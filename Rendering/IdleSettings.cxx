// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IdleSettings.h"

#include "AppearanceFromVTK.h"
#include "BackgroundFromVTK.h"
#include "CameraFromVTK.h"
#include "InputName.h"
#include "LinesFromVTK.h"
#include "PassArrays.h"
#include "SceneSettings.h"
#include "TexturesOfInputs.h"

#include "vtkCellData.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace lambent::adapters
{
namespace
{
using Messages = std::vector<std::string>;

/// `whose` is the beginning of the message.
void addProperty(Messages& messages, const std::string& whose, vtkProperty* property)
{
  const auto add = [&](bool isSet, const char* text)
  {
    if (isSet)
    {
      messages.push_back(whose + " vtkProperty::" + text);
    }
  };
  add(property->GetInterpolation() == VTK_PBR,
    "SetInterpolationToPBR() only selects smooth shading. Call SetInterpolationToPhong() instead.");
  add(property->GetNumberOfTextures() > 0,
    "SetTexture() has no effect. Call SetInputTexture() and RemoveAllTextures().");
}

/// Names several things in a few words, given the name of the first.
std::string nameSeveral(const std::string& first, std::size_t count)
{
  return first + (count > 1 ? " and " + std::to_string(count - 1) + " more" : "");
}

/// Checks each property once, even if several inputs share it.
void addProperties(Messages& messages, const SceneSettings& settings)
{
  vtkProperty* const common = settings.property;
  bool isCommonUsed = false;
  // The connections that use each, ordered by the first of them.
  std::vector<std::pair<vtkProperty*, std::vector<int>>> users;
  std::unordered_map<vtkProperty*, std::size_t> placeOf;
  for (const SceneSettings::Input& input : settings.inputs)
  {
    vtkProperty* const own = input.property;
    isCommonUsed = isCommonUsed || !own || own == common;
    if (own && own != common)
    {
      const auto [place, isNew] = placeOf.emplace(own, users.size());
      if (isNew)
      {
        users.emplace_back(own, std::vector<int>());
      }
      std::vector<int>& connections = users[place->second].second;
      if (connections.empty() || connections.back() != input.connection) // once for all its blocks
      {
        connections.push_back(input.connection);
      }
    }
  }
  for (const auto& [property, connections] : users)
  {
    const std::string first = nameOfInput(connections.front(), -1, "");
    addProperty(messages, nameSeveral(first, connections.size()) + ":", property);
  }
  if (isCommonUsed && common)
  {
    addProperty(messages, "The property of all inputs:", common);
  }
}

/// Names all leaves that cannot be drawn, or, if there are many, the first ones.
void addUndrawableBlocks(Messages& messages, const std::vector<std::string>& blocks)
{
  constexpr std::size_t mostNamed = 20;
  if (blocks.empty())
  {
    return;
  }
  std::string list;
  for (std::size_t k = 0; k < std::min(mostNamed, blocks.size()); ++k)
  {
    list += (k > 0 ? "; " : "") + blocks[k];
  }
  if (blocks.size() > mostNamed)
  {
    list += "; and " + std::to_string(blocks.size() - mostNamed) + " more";
  }
  messages.push_back("Only vtkPolyData can be rendered; this is left out: " + list +
    ". Connect the input through vtkCompositeDataGeometryFilter, or each block through "
    "vtkDataSetSurfaceFilter, which extract surfaces.");
}

/// Why no normals are computed, and the remedy. Empty if some are computed, or if no input has
/// faces.
std::string whyNoNormalsAreComputed(const SceneSettings& settings)
{
  bool isAnyDrawn = false, isAnySmooth = false;
  for (const SceneSettings::Input& input : settings.inputs)
  {
    if (input.spheres.areOn() ||
      lineStyleFromVTK(settings.propertyOf(input)).representation != LineStyle::Surface ||
      input.mesh->GetNumberOfPolys() + input.mesh->GetNumberOfStrips() == 0)
    {
      continue;
    }
    const bool isSmooth = appearanceFromVTK(settings.propertyOf(input)).shading == Shading::Smooth;
    if (isSmooth && !(settings.usePointNormals && input.mesh->GetPointData()->GetNormals()))
    {
      return "";
    }
    isAnyDrawn = true;
    isAnySmooth = isAnySmooth || isSmooth;
  }
  return !isAnyDrawn ? ""
    : isAnySmooth
    ? "all smooth-shaded inputs already have point normals. Call UsePointNormalsOff() to compute "
      "normals instead"
    : "no input is lit and smooth-shaded. Call vtkProperty::LightingOn() and "
      "SetInterpolationToPhong()";
}

void addNormalSettings(Messages& messages, const SceneSettings& settings)
{
  const bool isAngleSet = settings.featureAngle != SceneSettings().featureAngle;
  const bool isSplittingOff = !settings.splitting;
  const std::string reason = isAngleSet || isSplittingOff ? whyNoNormalsAreComputed(settings) : "";
  if (!reason.empty() && isAngleSet)
  {
    messages.push_back("SetFeatureAngle() has no effect: " + reason + ", or set it back to 30.");
  }
  if (!reason.empty() && isSplittingOff)
  {
    messages.push_back("SplittingOff() has no effect: " + reason + ", or call SplittingOn().");
  }
}

/// Whether colours are described but not used.
bool isAnySet(const InputColors& colors)
{
  return !colors.arrayName.empty() || colors.component != 0 || colors.lookupTable ||
    colors.hasScalarRange || colors.interpolateScalarsBeforeMapping;
}

void addColors(Messages& messages, const SceneSettings& settings)
{
  std::vector<std::string> unused, without; // names of inputs
  for (const SceneSettings::Input& input : settings.inputs)
  {
    if (!input.colors.scalarVisibility && isAnySet(input.colors))
    {
      unused.push_back(nameOf(input));
    }
    if (input.colors.scalarVisibility && input.colors.arrayName.empty() &&
      !input.mesh->GetPointData()->GetScalars() && !input.mesh->GetCellData()->GetScalars())
    {
      without.push_back(nameOf(input));
    }
  }
  if (!unused.empty())
  {
    messages.push_back(nameSeveral(unused.front(), unused.size()) +
      ": the settings of its colours have no effect. Call SetInputScalarVisibility() with true.");
  }
  if (!without.empty())
  {
    messages.push_back(nameSeveral(without.front(), without.size()) +
      ": SetInputScalarVisibility() has no effect, since there are no active scalars. Call "
      "SetInputColorArray() with the name of an array.");
  }
}

/// Whether the direction of a light is undefined: it is aimed, but its position is its focal point.
bool isWithoutDirection(vtkLight* light)
{
  const double *from = light->GetPosition(), *to = light->GetFocalPoint();
  const bool isAimed = !light->GetPositional() || light->GetConeAngle() < 90.0;
  return !light->LightTypeIsHeadlight() && isAimed && from[0] == to[0] && from[1] == to[1] &&
    from[2] == to[2];
}

void addLights(Messages& messages, const SceneSettings& settings)
{
  for (std::size_t k = 0; k < settings.lights.size(); ++k)
  {
    if (settings.lights[k]->GetSwitch() && isWithoutDirection(settings.lights[k]))
    {
      messages.push_back("Light " + std::to_string(k) +
        " gives no diffuse light: it is at its own focal point, so it has no direction. Call "
        "vtkLight::SetPosition() or SetFocalPoint().");
    }
  }
}

void addBackground(Messages& messages, const SceneSettings& settings)
{
  const bool hasColor = settings.background != Vec3(0.0) || settings.backgroundTop() != Vec3(0.0);
  if (settings.outputAlpha && (hasColor || settings.backgroundImage))
  {
    messages.push_back(
      std::string(settings.backgroundImage ? "SetBackgroundImage()" : "SetBackground()") +
      " has no effect: with OutputAlpha the picture has no background. Call OutputAlphaOff(), or "
      "composite the picture over a background afterwards.");
  }
  else if (hasColor && isOpaque(settings.backgroundImage))
  {
    messages.push_back("SetBackground() has no effect: the background image has no alpha, so it "
                       "hides the colour. Call SetBackgroundImage() with an image of 2 or 4 "
                       "components, or SetBackground(0, 0, 0) and GradientBackgroundOff().");
  }
  else if (!settings.gradientBackground && settings.background2 != Vec3(0.0) &&
    settings.background2 != settings.background)
  {
    messages.push_back("SetBackground2() has no effect: there is no gradient. Call "
                       "GradientBackgroundOn(), or SetBackground2(0, 0, 0).");
  }
}
}

std::vector<std::string> findIdleSettings(const SceneSettings& settings)
{
  Messages messages;
  if (settings.camera)
  {
    const std::string names = unsupportedSettings(settings.camera);
    if (!names.empty())
    {
      messages.push_back(
        "The camera has settings that are not supported and are ignored: " + names + ".");
    }
  }
  addProperties(messages, settings);
  addColors(messages, settings);
  addUndrawableBlocks(messages, settings.undrawableBlocks);
  addNormalSettings(messages, settings);
  addLights(messages, settings);
  addBackground(messages, settings);
  for (const std::string& message : findIdleTextures(settings))
  {
    messages.push_back(message);
  }
  for (const std::string& message : describeMissing(settings))
  {
    messages.push_back(message);
  }
  return messages;
}
}
