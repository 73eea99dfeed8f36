// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLambentAlgorithm.h"

#include "Chunks.h"
#include "HugePages.h"
#include "IdleSettings.h"
#include "ImageContract.h"
#include "NewMessages.h"
#include "OutputImage.h"
#include "PassArrays.h"
#include "Render.h"
#include "SceneFromSettings.h"
#include "Vec3FromVTK.h"
#include "WatchedParallel.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <sstream>
#include <stdexcept>

using namespace lambent::adapters;

namespace
{
/// How much of the whole is done when there is a scene with normals, roughly.
constexpr double sceneShare = 0.3;

/// Sets a flag for as long as it exists.
struct ScopedFlag
{
  bool& flag;
  explicit ScopedFlag(bool& f)
    : flag(f)
  {
    this->flag = true;
  }
  ~ScopedFlag() { this->flag = false; }
  ScopedFlag(const ScopedFlag&) = delete;
};
}

struct vtkLambentAlgorithm::Internals
{
  std::vector<SceneSettings::PassArray> PassArrays;
  NewMessages Warnings;
  bool IsExecuting = false; ///< Executives do not prevent a request within a request.
};

//------------------------------------------------------------------------------
vtkLambentAlgorithm::vtkLambentAlgorithm()
  : ImageSize{ 300, 300 }
  , Supersampling(1)
  , AmbientModel(PER_LIGHT)
  , TwoSidedLighting(1)
  , Background{ 0.0, 0.0, 0.0 }
  , GradientBackground(0)
  , Background2{ 0.0, 0.0, 0.0 }
  , BackgroundImage(nullptr)
  , OutputAlpha(0)
  , OutputScalarType(VTK_UNSIGNED_CHAR)
  , GenerateDepth(0)
  , GenerateNormals(0)
  , GeneratePositions(0)
  , GenerateIds(0)
  , Internal(new Internals)
{
}

vtkLambentAlgorithm::~vtkLambentAlgorithm()
{
  this->SetBackgroundImage(nullptr);
}

vtkCxxSetObjectMacro(vtkLambentAlgorithm, BackgroundImage, vtkImageData);

//------------------------------------------------------------------------------
void vtkLambentAlgorithm::SetOutputScalarType(int type)
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

//------------------------------------------------------------------------------
void vtkLambentAlgorithm::AddPassArray(int association, const char* name)
{
  if (!name || !*name)
  {
    vtkErrorMacro("AddPassArray() was given no name; it takes the name of a point or cell array.");
    return;
  }
  this->Internal->PassArrays.push_back({ association, name });
  this->Modified();
}

void vtkLambentAlgorithm::RemoveAllPassArrays()
{
  if (!this->Internal->PassArrays.empty())
  {
    this->Internal->PassArrays.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkLambentAlgorithm::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->BackgroundImage ? std::max(time, this->BackgroundImage->GetMTime()) : time;
}

int vtkLambentAlgorithm::GetImageContractVersion()
{
  return lambent::ImageContractVersion;
}

//------------------------------------------------------------------------------
std::string vtkLambentAlgorithm::DescribeSamplingDefect() const
{
  constexpr int mostSamples = 16;
  std::ostringstream text;
  const std::int64_t largest = std::max(this->ImageSize[0], this->ImageSize[1]);
  if (this->Supersampling < 1 || this->Supersampling > mostSamples)
  {
    text << "The supersampling is " << this->Supersampling
         << "; it must be 1 to 16. Call SetSupersampling().";
  }
  else if (largest * this->Supersampling > std::numeric_limits<int>::max())
  {
    text << "An image of " << this->ImageSize[0] << " x " << this->ImageSize[1] << " pixels with "
         << this->Supersampling << " x " << this->Supersampling
         << " samples each has more than 2147483647 samples along an axis. Call SetImageSize() or "
            "SetSupersampling() with a smaller value.";
  }
  return text.str();
}

int vtkLambentAlgorithm::RequestInformation(
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
  const std::string defect = this->DescribeSamplingDefect();
  if (!defect.empty())
  {
    vtkErrorMacro(<< defect);
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
  vtkDataObject::SetPointDataActiveScalarInfo(
    outInfo, this->OutputScalarType, this->OutputAlpha ? 4 : 3);
  return 1;
}

//------------------------------------------------------------------------------
int vtkLambentAlgorithm::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  int extent[6];
  outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
  if (extent[0] > extent[1] || extent[2] > extent[3] || extent[4] > extent[5])
  {
    output->Initialize(); // a piece without pixels
    return 1;
  }
  if (this->Internal->IsExecuting)
  {
    vtkErrorMacro("The picture is requested while it is rendered. If it is the image of one of its "
                  "own textures, give the texture another image.");
    output->Initialize();
    return 0;
  }
  const ScopedFlag executing(this->Internal->IsExecuting);
  try
  {
    this->MakePicture(inputs, outInfo, output);
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
      << " pixels and its intermediate data. Call SetImageSize() with a smaller size, or request "
         "the image in parts.");
  }
  catch (const std::exception& failure)
  {
    vtkErrorMacro(<< failure.what());
  }
  output->Initialize();
  return 0;
}

//------------------------------------------------------------------------------
void vtkLambentAlgorithm::AddOwnSettings(SceneSettings& scene)
{
  std::copy_n(this->ImageSize, 2, scene.imageSize);
  scene.ambientModel =
    this->AmbientModel == SCENE ? lambent::AmbientModel::Scene : lambent::AmbientModel::PerLight;
  scene.twoSidedLighting = this->TwoSidedLighting != 0;
  scene.background = vec3FromVTK(this->Background);
  scene.background2 = vec3FromVTK(this->Background2);
  scene.gradientBackground = this->GradientBackground != 0;
  scene.backgroundImage = this->BackgroundImage;
  scene.outputAlpha = this->OutputAlpha != 0;
  scene.passArrays = this->Internal->PassArrays;
}

OutputSettings vtkLambentAlgorithm::DescribeOutput() const
{
  OutputSettings settings;
  std::copy_n(this->ImageSize, 2, settings.size);
  settings.scalarType = this->OutputScalarType;
  settings.samples = this->Supersampling;
  settings.alpha = this->OutputAlpha != 0;
  settings.ids = this->GenerateIds != 0;
  const auto add = [&](vtkTypeBool isWanted, lambent::PassContent content)
  {
    if (isWanted)
    {
      settings.contents.push_back(content);
    }
  };
  add(this->GenerateDepth, lambent::PassContent::Depth);
  add(this->GenerateNormals, lambent::PassContent::Normal);
  add(this->GeneratePositions, lambent::PassContent::Position);
  settings.passArrays = this->Internal->PassArrays;
  return settings;
}

void vtkLambentAlgorithm::WarnOfIdleSettings(const SceneSettings& scene)
{
  for (const std::string& warning : this->Internal->Warnings.update(findIdleSettings(scene)))
  {
    vtkWarningMacro(<< warning);
  }
}

void vtkLambentAlgorithm::MakePicture(
  vtkInformationVector** inputs, vtkInformation* outInfo, vtkImageData* output)
{
  SceneSettings settings;
  this->AddOwnSettings(settings);
  this->DescribeScene(inputs, settings);
  this->WarnOfIdleSettings(settings);
  const WatchedParallel parallel(this);
  parallel.checkAbort(); // a StartEvent observer may already have aborted
  this->SetProgressText("normals");
  const SceneFromSettings description(settings, lambent::Share(parallel, 0.0, sceneShare));
  const double begin = description.surfaces().hasComputedNormals()
    ? sceneShare
    : sceneShare * (1.0 - SceneFromSettings::normalsShare);
  parallel.checkAbort();
  this->SetProgressText("rendering");
  OutputSettings outputSettings = this->DescribeOutput();
  outputSettings.blockIds = outputSettings.ids && settings.hasCompositeInput;
  lambent::Image image = allocateImage(outputSettings, description.surfaces(), outInfo, output);
  std::unique_ptr<std::uint32_t[]> primitives;
  if (this->GenerateIds)
  {
    const auto count = static_cast<std::size_t>(output->GetNumberOfPoints());
    primitives.reset(new std::uint32_t[count]); // not zeroed
    lambent::useHugePages(primitives.get(), count * sizeof(std::uint32_t));
    image.primitives = primitives.get();
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
    addIds(primitives.get(), description.surfaces(), outputSettings.blockIds, parallel, output);
  }
}

//------------------------------------------------------------------------------
void vtkLambentAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto printColor = [&](const char* name, const double color[3])
  { os << indent << name << ": (" << color[0] << ", " << color[1] << ", " << color[2] << ")\n"; };
  const auto printSwitch = [&](const char* name, vtkTypeBool value)
  { os << indent << name << ": " << (value ? "On" : "Off") << "\n"; };
  os << indent << "ImageSize: " << this->ImageSize[0] << " x " << this->ImageSize[1] << "\n";
  os << indent << "Supersampling: " << this->Supersampling << "\n";
  os << indent << "AmbientModel: " << (this->AmbientModel == SCENE ? "Scene" : "PerLight") << "\n";
  printSwitch("TwoSidedLighting", this->TwoSidedLighting);
  printColor("Background", this->Background);
  printSwitch("GradientBackground", this->GradientBackground);
  printColor("Background2", this->Background2);
  os << indent << "BackgroundImage: "
     << (this->BackgroundImage ? this->BackgroundImage->GetClassName() : "(none)") << "\n";
  printSwitch("OutputAlpha", this->OutputAlpha);
  os << indent << "OutputScalarType: " << vtkImageScalarTypeNameMacro(this->OutputScalarType)
     << "\n";
  printSwitch("GenerateDepth", this->GenerateDepth);
  printSwitch("GenerateNormals", this->GenerateNormals);
  printSwitch("GeneratePositions", this->GeneratePositions);
  printSwitch("GenerateIds", this->GenerateIds);
  for (const SceneSettings::PassArray& array : this->Internal->PassArrays)
  {
    os << indent << "PassArray: " << describe(array) << "\n";
  }
}
