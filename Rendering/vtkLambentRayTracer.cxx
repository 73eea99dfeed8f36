// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLambentRayTracer.h"

#include "Bounds.h"
#include "CameraFrame.h"
#include "CameraFromVTK.h"
#include "InputSurfaces.h"
#include "RayTracerInternals.h"
#include "SMPParallel.h"
#include "SceneSettings.h"

#include "vtkCamera.h"
#include "vtkCollectionRange.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <algorithm>
#include <exception>
#include <string>

using namespace lambent::adapters;

vtkStandardNewMacro(vtkLambentRayTracer);
vtkCxxSetObjectMacro(vtkLambentRayTracer, Camera, vtkCamera);
vtkCxxSetObjectMacro(vtkLambentRayTracer, Property, vtkProperty);

//------------------------------------------------------------------------------
vtkLambentRayTracer::vtkLambentRayTracer()
  : Camera(nullptr)
  , Property(nullptr)
  , UsePointNormals(1)
  , Splitting(1)
  , FeatureAngle(SceneSettings().featureAngle)
  , Internal(new Internals)
{
  this->SetNumberOfInputPorts(1);
}

vtkLambentRayTracer::~vtkLambentRayTracer()
{
  this->SetCamera(nullptr);
  this->SetProperty(nullptr);
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::ResetCamera()
{
  try
  {
    SceneSettings scene;
    for (int connection = 0; connection < this->GetNumberOfInputConnections(0); ++connection)
    {
      int port = 0;
      vtkAlgorithm* producer = this->GetInputAlgorithm(0, connection, port);
      producer->Update(port);
      this->Internal->addInput(producer->GetOutputDataObject(port), connection, scene);
    }
    const SMPParallel parallel;
    const std::vector<lambent::Appearance> appearances(scene.inputs.size());
    const std::vector<LineStyle> lineStyles(scene.inputs.size()); // none changes the bounds
    const InputSurfaces surfaces(scene.inputs, appearances, lineStyles, parallel);
    vtkSmartPointer<vtkCamera> camera = this->Camera;
    if (!camera)
    {
      camera = vtkSmartPointer<vtkCamera>::New();
    }
    const lambent::Camera framed = frameBounds(cameraFromVTK(camera),
      findBounds(surfaces.surfaces(), parallel), this->ImageSize[0], this->ImageSize[1]);
    applyFraming(framed, camera);
    this->SetCamera(camera);
  }
  catch (const std::exception& failure)
  {
    vtkErrorMacro(<< failure.what());
  }
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::AddLight(vtkLight* light)
{
  if (!light)
  {
    vtkErrorMacro("AddLight() was given no light.");
    return;
  }
  this->Internal->Lights->AddItem(light);
  this->Modified();
}

void vtkLambentRayTracer::RemoveLight(vtkLight* light)
{
  this->Internal->Lights->RemoveItem(light);
  this->Modified();
}

void vtkLambentRayTracer::RemoveAllLights()
{
  this->Internal->Lights->RemoveAllItems();
  this->Modified();
}

vtkLightCollection* vtkLambentRayTracer::GetLights()
{
  return this->Internal->Lights;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkLambentRayTracer::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  const auto cover = [&time](vtkObject* object)
  {
    if (object)
    {
      time = std::max(time, object->GetMTime());
    }
  };
  cover(this->Camera);
  cover(this->Property);
  for (const auto& own : this->Internal->Inputs.all())
  {
    cover(own.second.Property);
    cover(own.second.Colors.lookupTable);
    cover(own.second.Transform);
    cover(own.second.BlockAttributes);
    if (vtkTexture* const texture = own.second.Texture)
    {
      cover(texture);
      cover(texture->GetTransform());
      cover(texture->GetLookupTable());
      // Not GetInput(), which would ask the filters that produce the image for their times.
      cover(texture->GetNumberOfInputConnections(0) > 0
          ? vtkDataObject::GetData(texture->GetInputInformation())
          : nullptr);
    }
  }
  cover(this->Internal->Lights);
  for (vtkLight* light : vtk::Range(this->Internal->Lights.Get()))
  {
    cover(light);
    cover(light->GetTransformMatrix());
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkLambentRayTracer::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  // Otherwise the executive would make a composite data set of pictures, one per block.
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkLambentRayTracer::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // Whichever part of the image is requested, all of the scene may be visible in it.
  for (int i = 0; i < inputs[0]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* inInfo = inputs[0]->GetInformationObject(i);
    inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    inInfo->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    inInfo->Remove(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT());
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::DescribeScene(vtkInformationVector** inputs, SceneSettings& scene)
{
  for (int k = 0; k < inputs[0]->GetNumberOfInformationObjects(); ++k)
  {
    this->Internal->addInput(vtkDataObject::GetData(inputs[0], k), k, scene);
  }
  scene.camera = this->Camera;
  for (vtkLight* light : vtk::Range(this->Internal->Lights.Get()))
  {
    scene.lights.push_back(light);
  }
  scene.property = this->Property;
  scene.usePointNormals = this->UsePointNormals != 0;
  scene.splitting = this->Splitting != 0;
  scene.featureAngle = this->FeatureAngle;
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto printSwitch = [&](const char* name, vtkTypeBool value)
  { os << indent << name << ": " << (value ? "On" : "Off") << "\n"; };
  const auto printObject = [&](const std::string& name, vtkObject* object)
  {
    os << indent << name << ":";
    if (object)
    {
      os << "\n";
      object->PrintSelf(os, indent.GetNextIndent());
    }
    else
    {
      os << " (none)\n";
    }
  };
  printObject("Camera", this->Camera);
  printObject("Lights", this->Internal->Lights);
  printObject("Property", this->Property);
  this->PrintInputs(os, indent);
  printSwitch("UsePointNormals", this->UsePointNormals);
  printSwitch("Splitting", this->Splitting);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
}
