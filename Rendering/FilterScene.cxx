// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterScene.h"

#include "CameraFrame.h"
#include "SceneFromVTK.h"
#include "vtkLambentRayTracer.h"

#include "vtkCollectionRange.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkProperty.h"

#include <cmath>
#include <stdexcept>

namespace lambent::adapters
{
FilterScene::FilterScene(
  vtkLambentRayTracer* filter, const std::vector<vtkPolyData*>& inputs, const Parallel& parallel)
  : Filter(filter)
  , Surfaces(inputs, appearances(filter, inputs.size()), parallel)
{
  this->addCamera(parallel);
  this->addLights();
  this->addBackground();
  if (!std::isfinite(filter->GetFeatureAngle()))
  {
    throw std::runtime_error(
      "The feature angle is not a finite number. Call SetFeatureAngle() with 0 to 180 degrees.");
  }
  constexpr double smoothEverywhere = 180.0;
  this->Surfaces.addNormals(filter->GetUsePointNormals() != 0,
    filter->GetSplitting() ? filter->GetFeatureAngle() : smoothEverywhere, parallel);
  this->Description.surfaces = this->Surfaces.surfaces();
}

std::vector<Appearance> FilterScene::appearances(vtkLambentRayTracer* filter, std::size_t count)
{
  std::vector<Appearance> result;
  for (int k = 0; k < static_cast<int>(count); ++k)
  {
    vtkProperty* own = filter->GetInputProperty(k);
    result.push_back(appearanceFromVTK(own ? own : filter->GetProperty()));
    if (!isFinite(result.back()))
    {
      throw std::runtime_error("Input " + std::to_string(k) +
        ": its vtkProperty has a colour or coefficient that is not a finite number. Call "
        "SetColor(), SetDiffuse() and SetAmbient() with finite ones.");
    }
  }
  return result;
}

void FilterScene::addCamera(const Parallel& parallel)
{
  Camera& camera = this->Description.camera;
  if (this->Filter->GetCamera())
  {
    camera = cameraFromVTK(this->Filter->GetCamera());
  }
  else
  {
    const int* size = this->Filter->GetImageSize();
    camera = frameBounds(camera, findBounds(this->Surfaces.surfaces(), parallel), size[0], size[1]);
  }
  const std::string defect = describeDefect(camera);
  if (!defect.empty())
  {
    throw std::runtime_error(defect);
  }
}

void FilterScene::addLights()
{
  Scene& scene = this->Description;
  scene.ambientModel = this->Filter->GetAmbientModel() == vtkLambentRayTracer::SCENE
    ? AmbientModel::Scene
    : AmbientModel::PerLight;
  scene.twoSidedLighting = this->Filter->GetTwoSidedLighting() != 0;
  int index = 0;
  for (vtkLight* light : vtk::Range(this->Filter->GetLights()))
  {
    if (light->GetSwitch())
    {
      scene.lights.push_back(lightFromVTK(light, scene.camera));
      const std::string defect = describeDefect(scene.lights.back());
      if (!defect.empty())
      {
        throw std::runtime_error("Light " + std::to_string(index) + " " + defect);
      }
    }
    ++index;
  }
  if (index == 0)
  {
    scene.lights.push_back(headlight(scene.camera));
  }
}

void FilterScene::addBackground()
{
  const double* bottom = this->Filter->GetBackground();
  const double* top =
    this->Filter->GetGradientBackground() ? this->Filter->GetBackground2() : bottom;
  for (int channel = 0; channel < 3; ++channel)
  {
    if (!std::isfinite(bottom[channel]) || !std::isfinite(top[channel]))
    {
      throw std::runtime_error("The background has a channel that is not a finite number. Call "
                               "SetBackground() and SetBackground2() with finite ones.");
    }
    this->Description.background[channel] = bottom[channel];
    this->Description.backgroundTop[channel] = top[channel];
  }
}
}
