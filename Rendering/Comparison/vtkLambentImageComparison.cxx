// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLambentImageComparison.h"

#include "ImageDifference.h"
#include "InputErrors.h"
#include "StructuralSimilarity.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace
{
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

std::string describe(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  std::ostringstream text;
  text << size[0] << " x " << size[1];
  if (size[2] != 1)
  {
    text << " x " << size[2];
  }
  text << ", " << scalars->GetNumberOfComponents()
       << (scalars->GetNumberOfComponents() == 1 ? " component of " : " components of ")
       << scalars->GetDataTypeAsString();
  return text.str();
}

/// Throws unless the image is empty or has a scalar for each pixel.
void checkScalars(vtkImageData* image, const char* name)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (image->GetNumberOfPoints() > 0 && !scalars)
  {
    throw std::runtime_error(std::string("The ") + name +
      " has no active point scalars to compare. Call GetPointData()->SetActiveScalars() with the "
      "name of the array.");
  }
  if (scalars && scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw std::runtime_error(std::string("The ") + name + " has " +
      std::to_string(scalars->GetNumberOfTuples()) + " scalars for " +
      std::to_string(image->GetNumberOfPoints()) +
      " pixels. Give the array as many tuples as the image has points.");
  }
}

/// Why two images cannot be compared pixel by pixel; empty if they can.
std::string findMismatch(vtkImageData* picture, vtkImageData* baseline)
{
  if (picture->GetNumberOfPoints() == 0 || baseline->GetNumberOfPoints() == 0)
  {
    return std::string(picture->GetNumberOfPoints() == 0 ? "the picture" : "the baseline") +
      " is empty";
  }
  const std::string a = describe(picture), b = describe(baseline);
  if (a != b)
  {
    return "the picture is " + a + ", but the baseline is " + b;
  }
  if (picture->GetDimensions()[2] != 1)
  {
    return "the images are " + a + "; a picture has a single slice";
  }
  return "";
}

/// " of 255" or the like if the largest value of the type is meaningful.
std::string fullScale(vtkImageData* image)
{
  const int type = image->GetScalarType();
  return type == VTK_UNSIGNED_CHAR ? " of 255" : type == VTK_UNSIGNED_SHORT ? " of 65535" : "";
}
}

vtkStandardNewMacro(vtkLambentImageComparison);

//------------------------------------------------------------------------------
vtkLambentImageComparison::vtkLambentImageComparison()
  : Metric(MAXIMUM_DIFFERENCE)
  , Tolerance(0.0)
  , Highlight(0)
{
  this->SetNumberOfInputPorts(2);
  this->Fail("nothing has been compared yet; call Update()");
}

bool vtkLambentImageComparison::HasStructuralSimilarity()
{
  return hasStructuralSimilarity();
}

const char* vtkLambentImageComparison::GetMetricAsString() const
{
  return this->Metric == MAXIMUM_DIFFERENCE ? "MaximumDifference"
    : this->Metric == ROOT_MEAN_SQUARE      ? "RootMeanSquare"
                                            : "StructuralSimilarity";
}

void vtkLambentImageComparison::SetTolerance(double tolerance)
{
  if (!(tolerance >= 0.0) || std::isinf(tolerance))
  {
    vtkErrorMacro("SetTolerance() was called with "
      << tolerance << "; the tolerance must be finite and not negative.");
    return;
  }
  if (this->Tolerance != tolerance)
  {
    this->Tolerance = tolerance;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkLambentImageComparison::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkLambentImageComparison::RequestInformation(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkInformation* outInfo = outputs->GetInformationObject(0);
  outInfo->CopyEntry(
    inputs[0]->GetInformationObject(0), vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  if (this->Highlight)
  {
    vtkDataObject::SetPointDataActiveScalarInfo(outInfo, VTK_UNSIGNED_CHAR, 3);
  }
  return 1;
}

int vtkLambentImageComparison::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int port = 0; port < 2; ++port) // both entirely, whatever part of the output is requested
  {
    vtkInformation* info = inputs[port]->GetInformationObject(0);
    if (info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
    {
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(),
        info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()), 6);
    }
    // A source that cannot produce pieces would not run for the second, and keep its old output.
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  return 1;
}

int vtkLambentImageComparison::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  ++this->NumberOfComparisons;
  vtkImageData* output = vtkImageData::GetData(outputs);
  output->Initialize();
  try
  {
    this->Compare(vtkImageData::GetData(inputs[0]), vtkImageData::GetData(inputs[1]), output);
    return 1;
  }
  catch (const std::exception& failure)
  {
    this->Fail(failure.what());
    vtkErrorMacro(<< failure.what());
    output->Initialize();
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkLambentImageComparison::Fail(const std::string& message)
{
  this->Passed = false;
  this->MaximumDifference = notANumber;
  this->RootMeanSquare = notANumber;
  this->StructuralSimilarity = notANumber;
  this->NumberOfChangedPixels = 0;
  this->ChangedExtent[0] = this->ChangedExtent[2] = 0;
  this->ChangedExtent[1] = this->ChangedExtent[3] = -1;
  this->Message = message;
}

void vtkLambentImageComparison::Compare(
  vtkImageData* picture, vtkImageData* baseline, vtkImageData* output)
{
  const std::string error = findInputError(this);
  if (!error.empty())
  {
    throw std::runtime_error(error);
  }
  checkScalars(picture, "picture");
  checkScalars(baseline, "baseline");
  const std::string mismatch = findMismatch(picture, baseline);
  if (!mismatch.empty())
  {
    this->Fail(mismatch);
    return;
  }
  this->Fail("");

  vtkDataArray* a = picture->GetPointData()->GetScalars();
  const int width = picture->GetDimensions()[0];
  auto values =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(a->GetDataType()));
  values->SetNumberOfComponents(a->GetNumberOfComponents());
  values->SetNumberOfTuples(a->GetNumberOfTuples());
  ImageDifference found;
  if (!subtractImages(a, baseline->GetPointData()->GetScalars(), width, found, values))
  {
    throw std::runtime_error(std::string("Scalars of type ") + a->GetDataTypeAsString() +
      " cannot be compared. Convert them to a number type.");
  }
  this->MaximumDifference = found.maximum;
  this->RootMeanSquare =
    std::sqrt(found.sumOfSquares / static_cast<double>(a->GetNumberOfValues()));
  this->NumberOfChangedPixels = found.changed;
  std::copy_n(found.extent, 4, this->ChangedExtent);
  if (this->Metric == STRUCTURAL_SIMILARITY)
  {
    this->StructuralSimilarity = structuralSimilarity(picture, baseline);
  }
  this->Judge(
    found.first % width, found.first / width, picture->GetNumberOfPoints(), fullScale(picture));

  if (this->Highlight)
  {
    auto bytes =
      vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_UNSIGNED_CHAR));
    bytes->SetNumberOfComponents(3);
    bytes->SetNumberOfTuples(a->GetNumberOfTuples());
    highlight(values, found.maximum, bytes);
    values = bytes;
  }
  values->SetName("Difference");
  output->CopyStructure(picture);
  output->GetPointData()->SetScalars(values);
}

// Sets Passed, and Message in one line for the user.
void vtkLambentImageComparison::Judge(
  vtkIdType x, vtkIdType y, vtkIdType pixels, const std::string& ofScale)
{
  const bool isExact = this->NumberOfChangedPixels == 0;
  const double metric = this->Metric == MAXIMUM_DIFFERENCE ? this->MaximumDifference
    : this->Metric == ROOT_MEAN_SQUARE                     ? this->RootMeanSquare
                                                           : 1.0 - this->StructuralSimilarity;
  this->Passed = isExact || (this->Tolerance > 0.0 && metric <= this->Tolerance);

  std::ostringstream text;
  if (isExact)
  {
    text << "all of " << pixels << " pixels are the same";
    this->Message = text.str();
    return;
  }
  text << this->NumberOfChangedPixels << " of " << pixels << " pixels differ, by at most "
       << this->MaximumDifference << ofScale << "; the first is (" << x << ", " << y << ")";
  if (this->Metric == ROOT_MEAN_SQUARE)
  {
    text << "; the root mean square is " << this->RootMeanSquare;
  }
  if (this->Metric == STRUCTURAL_SIMILARITY)
  {
    text << "; the structural similarity is " << this->StructuralSimilarity;
  }
  if (this->Tolerance > 0.0)
  {
    text << "; the tolerance of " << this->Tolerance
         << (this->Passed ? " allows it" : " is exceeded");
  }
  this->Message = text.str();
}

//------------------------------------------------------------------------------
void vtkLambentImageComparison::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Metric: " << this->GetMetricAsString() << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Highlight: " << (this->Highlight ? "On" : "Off") << "\n";
  os << indent << "Passed: " << (this->Passed ? "Yes" : "No") << "\n";
  os << indent << "MaximumDifference: " << this->MaximumDifference << "\n";
  os << indent << "RootMeanSquare: " << this->RootMeanSquare << "\n";
  os << indent << "StructuralSimilarity: " << this->StructuralSimilarity << "\n";
  os << indent << "NumberOfChangedPixels: " << this->NumberOfChangedPixels << "\n";
  os << indent << "ChangedExtent: (" << this->ChangedExtent[0] << ", " << this->ChangedExtent[1]
     << ", " << this->ChangedExtent[2] << ", " << this->ChangedExtent[3] << ")\n";
  os << indent << "Message: " << this->Message << "\n";
}
