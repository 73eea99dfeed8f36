// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLambentRayTracer.h"

#include "AppearanceFromVTK.h"
#include "Bounds.h"
#include "CameraFrame.h"
#include "CameraFromVTK.h"
#include "InputSettings.h"
#include "InputSurfaces.h"
#include "SMPParallel.h"
#include "SceneSettings.h"

#include "vtkCamera.h"
#include "vtkCollectionRange.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>

using namespace lambent::adapters;

struct vtkLambentRayTracer::Internals
{
  vtkNew<vtkLightCollection> Lights;
  InputSettings Inputs;
};

namespace
{
/// The input of a connection. Throws if it is composite; the executive refuses other types.
vtkPolyData* polyDataOf(vtkDataObject* input, int connection)
{
  if (vtkCompositeDataSet::SafeDownCast(input))
  {
    throw std::runtime_error("Input " + std::to_string(connection) + " is a " +
      input->GetClassName() +
      ", but vtkPolyData is required. Connect it through "
      "vtkCompositeDataGeometryFilter, which appends the surfaces of its blocks.");
  }
  return vtkPolyData::SafeDownCast(input);
}

std::string describeNegative(const char* method, int connection)
{
  return std::string(method) + " was given connection " + std::to_string(connection) +
    "; connections are counted from 0 in the order they were added.";
}
}

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
    std::vector<vtkPolyData*> inputs;
    std::vector<lambent::Appearance> appearances;
    std::vector<SphereSettings> spheres;
    for (int connection = 0; connection < this->GetNumberOfInputConnections(0); ++connection)
    {
      int port = 0;
      vtkAlgorithm* producer = this->GetInputAlgorithm(0, connection, port);
      producer->Update(port);
      if (auto* input = polyDataOf(producer->GetOutputDataObject(port), connection))
      {
        inputs.push_back(input);
        appearances.push_back(appearanceFromVTK(nullptr));
        spheres.push_back(this->Internal->Inputs.of(connection).Spheres);
      }
    }
    const SMPParallel parallel;
    const InputSurfaces surfaces(inputs, appearances, spheres, parallel);
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
void vtkLambentRayTracer::SetInputProperty(int connection, vtkProperty* property)
{
  if (connection < 0)
  {
    vtkErrorMacro(<< describeNegative("SetInputProperty()", connection));
    return;
  }
  this->Internal->Inputs.set(
    connection, [&](InputSetting& setting) { setting.Property = property; });
  this->Modified();
}

vtkProperty* vtkLambentRayTracer::GetInputProperty(int connection)
{
  return this->Internal->Inputs.property(connection);
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::SetInputSphereRadius(int connection, double radius)
{
  if (connection < 0)
  {
    vtkErrorMacro(<< describeNegative("SetInputSphereRadius()", connection));
    return;
  }
  this->Internal->Inputs.set(
    connection, [&](InputSetting& setting) { setting.Spheres.radius = radius; });
  this->Modified();
}

double vtkLambentRayTracer::GetInputSphereRadius(int connection)
{
  return this->Internal->Inputs.of(connection).Spheres.radius;
}

void vtkLambentRayTracer::SetInputSphereRadiusArray(int connection, const char* name)
{
  if (connection < 0)
  {
    vtkErrorMacro(<< describeNegative("SetInputSphereRadiusArray()", connection));
    return;
  }
  this->Internal->Inputs.set(
    connection, [&](InputSetting& setting) { setting.Spheres.radiusArray = name ? name : ""; });
  this->Modified();
}

const char* vtkLambentRayTracer::GetInputSphereRadiusArray(int connection)
{
  const std::string& name = this->Internal->Inputs.of(connection).Spheres.radiusArray;
  return name.empty() ? nullptr : name.c_str();
}

//------------------------------------------------------------------------------
// The settings of a connection stay with it.
void vtkLambentRayTracer::SetInputConnection(int port, vtkAlgorithmOutput* input)
{
  this->Internal->Inputs.followReplacement(
    this, [&]() { this->Superclass::SetInputConnection(port, input); });
}

void vtkLambentRayTracer::RemoveInputConnection(int port, vtkAlgorithmOutput* input)
{
  this->Internal->Inputs.follow(
    this, [&]() { this->Superclass::RemoveInputConnection(port, input); });
}

void vtkLambentRayTracer::RemoveInputConnection(int port, int idx)
{
  this->Internal->Inputs.follow(
    this, [&]() { this->Superclass::RemoveInputConnection(port, idx); }, idx);
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
  // DescribeScene() refuses it.
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
    scene.inputs.push_back({ polyDataOf(vtkDataObject::GetData(inputs[0], k), k),
      this->GetInputProperty(k), this->Internal->Inputs.of(k).Spheres });
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
  for (const auto& own : this->Internal->Inputs.all())
  {
    const std::string connection = std::to_string(own.first);
    if (own.second.Property)
    {
      printObject("InputProperty " + connection, own.second.Property);
    }
    if (own.second.Spheres.areOn())
    {
      const std::string& array = own.second.Spheres.radiusArray;
      os << indent << "InputSphereRadius " << connection << ": " << own.second.Spheres.radius
         << "\n";
      os << indent << "InputSphereRadiusArray " << connection << ": "
         << (array.empty() ? "(none)" : array) << "\n";
    }
  }
  printSwitch("UsePointNormals", this->UsePointNormals);
  printSwitch("Splitting", this->Splitting);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
}
