// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ComparePictures.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkImageAppend.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace
{

namespace fs = std::filesystem;

bool UpdateBaselines()
{
  const char* const value = std::getenv("LAMBENT_UPDATE_BASELINES");
  return value && std::string(value) == "1";
}

/// The picture in a file, or nothing.
vtkSmartPointer<vtkImageData> Read(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  if (!fs::is_regular_file(path) || !reader->CanReadFile(path.c_str()))
  {
    return nullptr;
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetErrorCode() == vtkErrorCode::NoError ? reader->GetOutput() : nullptr;
}

std::string Describe(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  std::ostringstream text;
  text << size[0] << " x " << size[1] << ", " << image->GetNumberOfScalarComponents()
       << " components of " << image->GetScalarTypeAsString();
  return text.str();
}

/// How many values differ; `difference` becomes 255 where they do and 0 elsewhere.
vtkIdType Subtract(vtkImageData* picture, vtkImageData* baseline, vtkImageData* difference)
{
  difference->DeepCopy(picture);
  vtkDataArray* const a = picture->GetPointData()->GetScalars();
  vtkDataArray* const b = baseline->GetPointData()->GetScalars();
  vtkDataArray* const d = difference->GetPointData()->GetScalars();
  vtkIdType count = 0;
  for (vtkIdType pixel = 0; pixel < a->GetNumberOfTuples(); ++pixel)
  {
    for (int channel = 0; channel < a->GetNumberOfComponents(); ++channel)
    {
      const bool differs = a->GetComponent(pixel, channel) != b->GetComponent(pixel, channel);
      d->SetComponent(pixel, channel, differs ? 255 : 0);
      count += differs;
    }
  }
  return count;
}

bool WriteSideBySide(
  vtkImageData* left, vtkImageData* middle, vtkImageData* right, const std::string& path)
{
  vtkNew<vtkImageAppend> strip;
  for (vtkImageData* image : { left, middle, right })
  {
    strip->AddInputData(image);
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(strip->GetOutputPort());
  writer->SetFileName(path.c_str());
  writer->Write();
  return writer->GetErrorCode() == vtkErrorCode::NoError;
}

/// What keeps the picture from being that of the file `baseline`; empty if nothing does.
std::string FindDifference(
  vtkImageData* picture, const std::string& baseline, const std::string& folder)
{
  const auto expected = Read(baseline);
  if (!expected)
  {
    return "There is no PNG baseline '" + baseline + "'.";
  }
  if (Describe(picture) != Describe(expected))
  {
    return "The picture is " + Describe(picture) + ", but the baseline '" + baseline + "' is " +
      Describe(expected) + ".";
  }
  vtkNew<vtkImageData> difference;
  const vtkIdType count = Subtract(picture, expected, difference);
  if (count == 0)
  {
    return "";
  }
  const std::string strip =
    (fs::path(folder) / (fs::path(baseline).stem().string() + ".difference.png")).string();
  const bool isWritten = WriteSideBySide(picture, expected, difference, strip);
  return std::to_string(count) + " of " + std::to_string(picture->GetNumberOfPoints()) + " x " +
    std::to_string(picture->GetNumberOfScalarComponents()) + " values differ from the baseline '" +
    baseline + "'. Picture, baseline and difference " +
    (isWritten ? "are side by side in '" : "could not be written to '") + strip + "'.";
}

} // namespace

std::string ComparePictures(
  const std::string& picture, const std::string& baseline, const std::string& folder)
{
  const auto seen = Read(picture);
  if (!seen)
  {
    return "There is no PNG picture '" + picture + "'.";
  }
  const std::string problem = FindDifference(seen, baseline, folder);
  if (!problem.empty() && UpdateBaselines())
  {
    fs::copy_file(picture, baseline, fs::copy_options::overwrite_existing);
    return "";
  }
  return problem.empty() ? ""
                         : problem + " Look at '" + picture +
      "'; if it is right, accept it by running the test with LAMBENT_UPDATE_BASELINES=1.";
}
