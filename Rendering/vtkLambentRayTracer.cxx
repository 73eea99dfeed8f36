// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLambentRayTracer.h"

#include "AppearanceFromVTK.h"
#include "Bounds.h"
#include "CameraFrame.h"
#include "CameraFromVTK.h"
#include "InputBlocks.h"
#include "InputSettings.h"
#include "InputSurfaces.h"
#include "SMPParallel.h"
#include "SceneSettings.h"
#include "TransformFromVTK.h"

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

#include <algorithm>
#include <exception>
#include <string>

using namespace lambent::adapters;

struct vtkLambentRayTracer::Internals
{
  vtkNew<vtkLightCollection> Lights;
  InputSettings Inputs;

  /// Adds the meshes of a connection to the scene.
  void addInput(vtkDataObject* data, int connection, SceneSettings& scene) const
  {
    const InputSetting& setting = this->Inputs.of(connection);
    SceneSettings::Input input;
    input.property = setting.Property;
    input.connection = connection;
    input.transform = transformFromVTK(setting.Transform, connection);
    input.colors = setting.Colors;
    input.spheres = setting.Spheres;
    addBlocks(input, data, setting.BlockAttributes, scene);
  }
};

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
    const InputSurfaces surfaces(scene.inputs, appearances, parallel);
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
// Makes a change of a setting of a connection, unless there is no such number.
template <typename Change>
void vtkLambentRayTracer::ChangeInput(int connection, const char* method, const Change& change)
{
  if (connection < 0)
  {
    vtkErrorMacro(<< method << "() was given connection " << connection
                  << "; connections are counted from 0 in the order they were added.");
    return;
  }
  change(this->Internal->Inputs.change(connection));
  this->Modified();
}

void vtkLambentRayTracer::SetInputProperty(int connection, vtkProperty* property)
{
  this->ChangeInput(
    connection, "SetInputProperty", [&](InputSetting& setting) { setting.Property = property; });
}

vtkProperty* vtkLambentRayTracer::GetInputProperty(int connection)
{
  return this->Internal->Inputs.of(connection).Property;
}

void vtkLambentRayTracer::SetInputTransform(int connection, vtkMatrix4x4* matrix)
{
  this->ChangeInput(connection, "SetInputTransform",
    [matrix](InputSetting& setting) { setting.Transform = matrix; });
}

vtkMatrix4x4* vtkLambentRayTracer::GetInputTransform(int connection)
{
  return this->Internal->Inputs.of(connection).Transform;
}

void vtkLambentRayTracer::SetInputBlockAttributes(
  int connection, vtkCompositeDataDisplayAttributes* attributes)
{
  this->ChangeInput(connection, "SetInputBlockAttributes",
    [attributes](InputSetting& setting) { setting.BlockAttributes = attributes; });
}

vtkCompositeDataDisplayAttributes* vtkLambentRayTracer::GetInputBlockAttributes(int connection)
{
  return this->Internal->Inputs.of(connection).BlockAttributes;
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::SetInputScalarVisibility(int connection, bool visibility)
{
  this->ChangeInput(connection, "SetInputScalarVisibility",
    [&](InputSetting& setting) { setting.Colors.scalarVisibility = visibility; });
}

bool vtkLambentRayTracer::GetInputScalarVisibility(int connection)
{
  return this->Internal->Inputs.of(connection).Colors.scalarVisibility;
}

void vtkLambentRayTracer::SetInputColorArray(int connection, int association, const char* name)
{
  this->ChangeInput(connection, "SetInputColorArray",
    [&](InputSetting& setting)
    {
      setting.Colors.association = association;
      setting.Colors.arrayName = name ? name : "";
    });
}

const char* vtkLambentRayTracer::GetInputColorArrayName(int connection)
{
  const std::string& name = this->Internal->Inputs.of(connection).Colors.arrayName;
  return name.empty() ? nullptr : name.c_str();
}

int vtkLambentRayTracer::GetInputColorArrayAssociation(int connection)
{
  return this->Internal->Inputs.of(connection).Colors.association;
}

void vtkLambentRayTracer::SetInputColorComponent(int connection, int component)
{
  this->ChangeInput(connection, "SetInputColorComponent",
    [&](InputSetting& setting) { setting.Colors.component = component; });
}

int vtkLambentRayTracer::GetInputColorComponent(int connection)
{
  return this->Internal->Inputs.of(connection).Colors.component;
}

void vtkLambentRayTracer::SetInputLookupTable(int connection, vtkScalarsToColors* table)
{
  this->ChangeInput(connection, "SetInputLookupTable",
    [&](InputSetting& setting) { setting.Colors.lookupTable = table; });
}

vtkScalarsToColors* vtkLambentRayTracer::GetInputLookupTable(int connection)
{
  return this->Internal->Inputs.of(connection).Colors.lookupTable;
}

void vtkLambentRayTracer::SetInputScalarRange(int connection, double low, double high)
{
  this->ChangeInput(connection, "SetInputScalarRange",
    [&](InputSetting& setting)
    {
      setting.Colors.hasScalarRange = true;
      setting.Colors.scalarRange[0] = low;
      setting.Colors.scalarRange[1] = high;
    });
}

void vtkLambentRayTracer::ResetInputScalarRange(int connection)
{
  this->ChangeInput(connection, "ResetInputScalarRange",
    [&](InputSetting& setting) { setting.Colors.hasScalarRange = false; });
}

bool vtkLambentRayTracer::GetInputScalarRange(int connection, double range[2])
{
  const InputColors& colors = this->Internal->Inputs.of(connection).Colors;
  std::copy_n(colors.scalarRange, 2, range);
  return colors.hasScalarRange;
}

void vtkLambentRayTracer::SetInputInterpolateScalarsBeforeMapping(int connection, bool before)
{
  this->ChangeInput(connection, "SetInputInterpolateScalarsBeforeMapping",
    [&](InputSetting& setting) { setting.Colors.interpolateScalarsBeforeMapping = before; });
}

bool vtkLambentRayTracer::GetInputInterpolateScalarsBeforeMapping(int connection)
{
  return this->Internal->Inputs.of(connection).Colors.interpolateScalarsBeforeMapping;
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::SetInputSphereRadius(int connection, double radius)
{
  this->ChangeInput(connection, "SetInputSphereRadius",
    [&](InputSetting& setting) { setting.Spheres.radius = radius; });
}

double vtkLambentRayTracer::GetInputSphereRadius(int connection)
{
  return this->Internal->Inputs.of(connection).Spheres.radius;
}

void vtkLambentRayTracer::SetInputSphereRadiusArray(int connection, const char* name)
{
  this->ChangeInput(connection, "SetInputSphereRadiusArray",
    [&](InputSetting& setting) { setting.Spheres.radiusArray = name ? name : ""; });
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
    cover(own.second.Colors.lookupTable);
    cover(own.second.Transform);
    cover(own.second.BlockAttributes);
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
  for (const auto& own : this->Internal->Inputs.all())
  {
    const std::string number = std::to_string(own.first);
    if (own.second.Property)
    {
      printObject("InputProperty " + number, own.second.Property);
    }
    const InputColors& colors = own.second.Colors;
    if (colors.scalarVisibility)
    {
      os << indent << "InputScalarVisibility " << number << ": On\n";
      const bool isOfCells = colors.association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
      os << indent << "InputColorArray " << number << ": "
         << (colors.arrayName.empty()
                ? "(active scalars)"
                : std::string(isOfCells ? "cell" : "point") + " array " + colors.arrayName)
         << "\n";
      os << indent << "InputColorComponent " << number << ": " << colors.component << "\n";
      printObject("InputLookupTable " + number, colors.lookupTable);
      os << indent << "InputScalarRange " << number << ": ";
      colors.hasScalarRange ? os << colors.scalarRange[0] << " to " << colors.scalarRange[1]
                            : os << "(automatic)";
      os << "\n"
         << indent << "InputInterpolateScalarsBeforeMapping " << number << ": "
         << (colors.interpolateScalarsBeforeMapping ? "On" : "Off") << "\n";
    }
    if (own.second.Spheres.areOn())
    {
      const std::string& array = own.second.Spheres.radiusArray;
      os << indent << "InputSphereRadius " << number << ": " << own.second.Spheres.radius << "\n";
      os << indent << "InputSphereRadiusArray " << number << ": "
         << (array.empty() ? "(none)" : array) << "\n";
    }
    if (own.second.Transform)
    {
      printObject("InputTransform " + number, own.second.Transform);
    }
    if (own.second.BlockAttributes)
    {
      printObject("InputBlockAttributes " + number, own.second.BlockAttributes);
    }
  }
  printSwitch("UsePointNormals", this->UsePointNormals);
  printSwitch("Splitting", this->Splitting);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
}
