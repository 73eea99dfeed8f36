// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneFromSettings.h"

#include "AppearanceFromVTK.h"
#include "BackgroundFromVTK.h"
#include "Bounds.h"
#include "CameraFrame.h"
#include "CameraFromVTK.h"
#include "Chunks.h"
#include "ColorsOfInputs.h"
#include "InputName.h"
#include "LightFromVTK.h"
#include "PassArrays.h"

#include "vtkLight.h"

#include <cmath>
#include <stdexcept>

namespace lambent::adapters
{
namespace
{
/// The fraction of the work that is done when the surfaces exist, and when their bounds are known.
constexpr double surfacesShare = 0.2;
constexpr double boundsShare = 1.0 - SceneFromSettings::normalsShare;
}

SceneFromSettings::SceneFromSettings(const SceneSettings& settings, const Parallel& parallel)
  : Settings(settings)
  , Surfaces(settings.inputs, appearances(settings), lineStyles(settings),
      Share(parallel, 0.0, surfacesShare))
{
  this->addCamera(Share(parallel, surfacesShare, boundsShare));
  this->addLights();
  this->addBackground();
  checkNames(settings.passArrays);
  this->addSurfaces(Share(parallel, boundsShare, 1.0));
}

std::vector<Appearance> SceneFromSettings::appearances(const SceneSettings& settings)
{
  std::vector<Appearance> result;
  for (const SceneSettings::Input& input : settings.inputs)
  {
    result.push_back(appearanceFromVTK(settings.propertyOf(input)));
    const std::string defect = describeDefect(result.back());
    if (!defect.empty())
    {
      throw std::runtime_error(nameOf(input) + ": its vtkProperty " + defect);
    }
    if (input.color)
    {
      result.back().diffuseColor = result.back().ambientColor = *input.color;
      if (!isFinite(*input.color))
      {
        throw std::runtime_error(nameOf(input) +
          ": its colour has a channel that is not a finite number. Call "
          "vtkCompositeDataDisplayAttributes::SetBlockColor() with finite ones.");
      }
    }
    if (input.opacity)
    {
      result.back().opacity = *input.opacity;
      if (!(*input.opacity >= 0.0 && *input.opacity <= 1.0))
      {
        throw std::runtime_error(nameOf(input) +
          ": its opacity is not a number from 0 to 1. Call "
          "vtkCompositeDataDisplayAttributes::SetBlockOpacity() with one.");
      }
    }
  }
  return result;
}

std::vector<LineStyle> SceneFromSettings::lineStyles(const SceneSettings& settings)
{
  std::vector<LineStyle> result;
  for (const SceneSettings::Input& input : settings.inputs)
  {
    result.push_back(lineStyleFromVTK(settings.propertyOf(input)));
  }
  return result;
}

void SceneFromSettings::addCamera(const Parallel& parallel)
{
  Camera& camera = this->Description.camera;
  if (this->Settings.camera)
  {
    camera = cameraFromVTK(this->Settings.camera);
  }
  else
  {
    const int* const size = this->Settings.imageSize;
    camera = frameBounds(camera, findBounds(this->Surfaces.surfaces(), parallel), size[0], size[1]);
  }
  const std::string defect = describeDefect(camera);
  if (!defect.empty())
  {
    throw std::runtime_error(defect);
  }
}

void SceneFromSettings::addLights()
{
  Scene& scene = this->Description;
  scene.ambientModel = this->Settings.ambientModel;
  scene.twoSidedLighting = this->Settings.twoSidedLighting;
  const std::vector<vtkLight*>& lights = this->Settings.lights;
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    if (lights[k]->GetSwitch())
    {
      scene.lights.push_back(lightFromVTK(lights[k], scene.camera));
      const std::string defect = describeDefect(scene.lights.back());
      if (!defect.empty())
      {
        throw std::runtime_error("Light " + std::to_string(k) + " " + defect);
      }
    }
  }
  if (lights.empty())
  {
    scene.lights.push_back(headlight(scene.camera));
  }
}

void SceneFromSettings::addBackground()
{
  if (this->Settings.outputAlpha)
  {
    return; // the picture has no background, so none can be wrong
  }
  this->Description.background = this->Settings.background;
  this->Description.backgroundTop = this->Settings.backgroundTop();
  if (!isFinite(this->Description.background) || !isFinite(this->Description.backgroundTop))
  {
    throw std::runtime_error("The background has a channel that is not a finite number. Call "
                             "SetBackground() and SetBackground2() with finite ones.");
  }
  this->Description.backgroundImage =
    backgroundFromVTK(this->Settings.backgroundImage, this->BackgroundSpans);
}

void SceneFromSettings::addSurfaces(const Parallel& parallel)
{
  if (!std::isfinite(this->Settings.featureAngle))
  {
    throw std::runtime_error(
      "The feature angle is not a finite number. Call SetFeatureAngle() with 0 to 180 degrees.");
  }
  constexpr double smoothEverywhere = 180.0;
  this->Surfaces.addNormals(this->Settings.usePointNormals,
    this->Settings.splitting ? this->Settings.featureAngle : smoothEverywhere, parallel);
  this->Colors = colorsOfInputs(this->Settings.inputs);
  this->Textures.emplace(this->Settings.inputs);
  for (std::size_t k = 0; k < this->Colors.size(); ++k)
  {
    this->Surfaces.addColors(k, this->Colors[k]);
    if (const Texture* const texture = this->Textures->of(k))
    {
      this->Surfaces.addTexture(k, *texture);
    }
  }
  this->Surfaces.numberPrimitives();
  this->Surfaces.addAttributes(this->Settings.passArrays);
  this->Description.surfaces = this->Surfaces.surfaces();
}
}
