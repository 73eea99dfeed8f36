// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLambentRayTracer.h"

#include "CameraFrame.h"
#include "Chunks.h"
#include "FilterScene.h"
#include "IdleSettings.h"
#include "ImageContract.h"
#include "InputSettings.h"
#include "NewMessages.h"
#include "OutputImage.h"
#include "Render.h"
#include "SceneFromVTK.h"
#include "WatchedParallel.h"

#include "vtkCamera.h"
#include "vtkCollectionRange.h"
#include "vtkImageData.h"
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
#include <new>
#include <stdexcept>

using namespace lambent::adapters;

namespace
{
/// How much of the whole is done when normals have been computed, roughly.
constexpr double normalsShare = 0.3;
}

struct vtkLambentRayTracer::Internals
{
  vtkNew<vtkLightCollection> Lights;
  InputSettings Inputs;
  NewMessages Warnings;
};

vtkStandardNewMacro(vtkLambentRayTracer);
vtkCxxSetObjectMacro(vtkLambentRayTracer, Camera, vtkCamera);
vtkCxxSetObjectMacro(vtkLambentRayTracer, Property, vtkProperty);

//------------------------------------------------------------------------------
vtkLambentRayTracer::vtkLambentRayTracer()
  : ImageSize{ 300, 300 }
  , Camera(nullptr)
  , Property(nullptr)
  , AmbientModel(PER_LIGHT)
  , TwoSidedLighting(1)
  , Background{ 0.0, 0.0, 0.0 }
  , GradientBackground(0)
  , Background2{ 0.0, 0.0, 0.0 }
  , OutputScalarType(VTK_UNSIGNED_CHAR)
  , UsePointNormals(1)
  , Splitting(1)
  , FeatureAngle(30.0)
  , GenerateIds(0)
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
    for (int connection = 0; connection < this->GetNumberOfInputConnections(0); ++connection)
    {
      int port = 0;
      vtkAlgorithm* producer = this->GetInputAlgorithm(0, connection, port);
      producer->Update(port);
      if (auto* input = vtkPolyData::SafeDownCast(producer->GetOutputDataObject(port)))
      {
        inputs.push_back(input);
        appearances.push_back(appearanceFromVTK(nullptr));
      }
    }
    const SMPParallel parallel;
    const InputSurfaces surfaces(inputs, appearances, parallel);
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
    vtkErrorMacro("SetInputProperty() was given connection "
      << connection << "; connections are counted from 0 in the order they were added.");
    return;
  }
  this->Internal->Inputs.setProperty(connection, property);
  this->Modified();
}

vtkProperty* vtkLambentRayTracer::GetInputProperty(int connection)
{
  return this->Internal->Inputs.property(connection);
}

// What is set for a connection stays with it.
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

void vtkLambentRayTracer::SetOutputScalarType(int type)
{
  if (type != VTK_UNSIGNED_CHAR && type != VTK_FLOAT)
  {
    vtkErrorMacro("SetOutputScalarType() was given type "
      << type << "; it takes VTK_UNSIGNED_CHAR (3) or VTK_FLOAT (10).");
    return;
  }
  if (this->OutputScalarType != type)
  {
    this->OutputScalarType = type;
    this->Modified();
  }
}

int vtkLambentRayTracer::GetImageContractVersion()
{
  return lambent::ImageContractVersion;
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
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkLambentRayTracer::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  if (this->ImageSize[0] < 1 || this->ImageSize[1] < 1)
  {
    vtkErrorMacro("The image size is " << this->ImageSize[0] << " x " << this->ImageSize[1]
                                       << "; both must be at least 1. Call SetImageSize().");
    vtkImageData::GetData(outInfo)->Initialize();
    return 0;
  }
  // The executive keeps the extent of a request that failed, and would add it to the
  // next one, even if the image has become smaller since.
  outInfo->Remove(vtkStreamingDemandDrivenPipeline::COMBINED_UPDATE_EXTENT());
  const int extent[6] = { 0, this->ImageSize[0] - 1, 0, this->ImageSize[1] - 1, 0, 0 };
  const double origin[3] = { 0.0, 0.0, 0.0 }, spacing[3] = { 1.0, 1.0, 1.0 };
  outInfo->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  outInfo->Set(vtkDataObject::ORIGIN(), origin, 3);
  outInfo->Set(vtkDataObject::SPACING(), spacing, 3);
  outInfo->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(outInfo, this->OutputScalarType, 3);
  return 1;
}

int vtkLambentRayTracer::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // Whatever part of the image is wanted, all of the scene may be seen in it.
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
int vtkLambentRayTracer::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  try
  {
    this->MakePicture(inputs[0], outInfo, output);
    return 1;
  }
  catch (const Aborted&)
  {
    // The executive shall not take the empty output for an up-to-date one.
    output->Initialize();
    outInfo->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
    return 1;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorMacro("There is not enough memory for an image of "
      << this->ImageSize[0] << " x " << this->ImageSize[1]
      << " pixels and the work on it. Call SetImageSize() with a smaller one, or ask for the "
         "image in parts.");
  }
  catch (const std::exception& failure)
  {
    vtkErrorMacro(<< failure.what());
  }
  output->Initialize();
  return 0;
}

void vtkLambentRayTracer::MakePicture(
  vtkInformationVector* inputs, vtkInformation* outInfo, vtkImageData* output)
{
  std::vector<vtkPolyData*> meshes;
  for (int k = 0; k < inputs->GetNumberOfInformationObjects(); ++k)
  {
    meshes.push_back(vtkPolyData::GetData(inputs, k));
  }
  for (const std::string& warning : this->Internal->Warnings.update(findIdleSettings(this, meshes)))
  {
    vtkWarningMacro(<< warning);
  }
  const WatchedParallel parallel(this);
  parallel.checkAbort(); // a StartEvent observer may already have aborted
  this->SetProgressText("normals");
  const FilterScene description(this, meshes, lambent::Share(parallel, 0.0, normalsShare));
  const double begin = description.surfaces().hasComputedNormals() ? normalsShare : 0.0;
  parallel.checkAbort();
  this->SetProgressText("rendering");
  lambent::Image image = allocateImage(this->ImageSize, this->OutputScalarType, outInfo, output);
  std::vector<std::uint32_t> triangles;
  if (this->GenerateIds)
  {
    triangles.resize(output->GetNumberOfPoints());
    image.triangles = triangles.data();
  }
  const lambent::Report report = lambent::render(description.scene(), image, parallel,
    [&](double fraction)
    {
      this->UpdateProgress(begin + (1.0 - begin) * fraction);
      return !isAborted(this);
    });
  if (report.outcome == lambent::Outcome::Aborted)
  {
    throw Aborted();
  }
  if (report.outcome == lambent::Outcome::BadMesh)
  {
    throw std::runtime_error(description.surfaces().describeWrongCorner(report.defects));
  }
  if (report.defects.notFinite > 0)
  {
    vtkWarningMacro(<< description.surfaces().describeNotFinite(report.defects));
  }
  if (this->GenerateIds)
  {
    addIds(triangles, description.surfaces(), output);
  }
}

//------------------------------------------------------------------------------
void vtkLambentRayTracer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto printColor = [&](const char* name, const double color[3])
  { os << indent << name << ": (" << color[0] << ", " << color[1] << ", " << color[2] << ")\n"; };
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
  os << indent << "ImageSize: " << this->ImageSize[0] << " x " << this->ImageSize[1] << "\n";
  printObject("Camera", this->Camera);
  printObject("Lights", this->Internal->Lights);
  printObject("Property", this->Property);
  for (const auto& own : this->Internal->Inputs.all())
  {
    printObject("InputProperty " + std::to_string(own.first), own.second.Property);
  }
  os << indent << "AmbientModel: " << (this->AmbientModel == SCENE ? "Scene" : "PerLight") << "\n";
  printSwitch("TwoSidedLighting", this->TwoSidedLighting);
  printColor("Background", this->Background);
  printSwitch("GradientBackground", this->GradientBackground);
  printColor("Background2", this->Background2);
  os << indent << "OutputScalarType: " << vtkImageScalarTypeNameMacro(this->OutputScalarType)
     << "\n";
  printSwitch("UsePointNormals", this->UsePointNormals);
  printSwitch("Splitting", this->Splitting);
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  printSwitch("GenerateIds", this->GenerateIds);
}
