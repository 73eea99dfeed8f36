// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief image tests in the style of vtkTesting: arguments -V and -T, tags for CDash
 *
 *     int TestPicture(int argc, char* argv[])
 *     {
 *       vtkNew<vtkLambentRayTracer> tracer;
 *       ...
 *       return !lambentRegressionTest(argc, argv, tracer.Get());
 *     }
 *
 * It replaces vtkRegressionTestImage() and vtkTesting::RegressionTest(), takes the same
 * arguments, and returns the same values:
 *
 *     -V BASELINE   the PNG file that the picture must match
 *     -T FOLDER     the folder for picture and difference if they do not match [.];
 *                   nothing is written into the folder of the baseline
 *
 * Unlike these, it is exact unless given a tolerance, in units of the scalars, and has no
 * alternative baselines. With LAMBENT_UPDATE_BASELINES=1 in the environment, a picture that
 * differs becomes the baseline if a PNG can hold it: one slice of 1 to 4 components of unsigned
 * char or unsigned short. A damaged baseline fails the test unless it is updated. A baseline that
 * is not a regular file, such as a folder, always fails.
 *
 * Link Lambent::Lambent and VTK::IOImage.
 */

#ifndef LambentRegressionTest_h
#define LambentRegressionTest_h

#include "LambentSameFile.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkLambentImageComparison.h"
#include "vtkLambentPNGReader.h"
#include "vtkNew.h"
#include "vtkPNGReader.h" // not needed here, but callers rely on it
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <string>

/// The values of vtkTesting. LambentNotRun: the arguments have no -V.
enum LambentRegressionResult
{
  LambentFailed = 0,
  LambentPassed = 1,
  LambentNotRun = 2
};

namespace lambentRegression
{
inline std::string argument(int argc, char* argv[], const std::string& flag)
{
  for (int k = 1; k + 1 < argc; ++k)
  {
    if (argv[k] == flag)
    {
      return argv[k + 1];
    }
  }
  return "";
}

/// Why a PNG file cannot hold the picture; empty if it can.
inline std::string whyNotPng(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || image->GetNumberOfPoints() == 0)
  {
    return "it is empty";
  }
  const int type = scalars->GetDataType(), components = scalars->GetNumberOfComponents();
  const bool fits = (type == VTK_UNSIGNED_CHAR || type == VTK_UNSIGNED_SHORT) && components <= 4 &&
    image->GetDimensions()[2] == 1 && scalars->GetNumberOfTuples() == image->GetNumberOfPoints();
  return fits ? ""
              : "a PNG file holds one slice of 1 to 4 components of unsigned char or unsigned "
                "short; this has " +
      std::to_string(image->GetDimensions()[2]) + (image->GetDimensions()[2] == 1 ? " of " : ", ") +
      std::to_string(components) + " of " + scalars->GetDataTypeAsString();
}

/// Writes a PNG file atomically: first to a temporary file beside the target of any links, which
/// is then renamed. Returns what went wrong, or an empty string.
inline std::string write(vtkImageData* image, const std::string& path)
{
  namespace fs = std::filesystem;
  const std::string problem = whyNotPng(image);
  if (!problem.empty())
  {
    return problem;
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (writer->GetErrorCode() != vtkErrorCode::NoError || !bytes)
  {
    return "vtkPNGWriter cannot encode it";
  }
  std::error_code error;
  const fs::path target = lambentFiles::resolve(path);
  fs::create_directories(target.parent_path(), error);
  if (fs::exists(target, error) && !fs::is_regular_file(target, error))
  {
    return "it exists and is not a regular file";
  }
  const fs::path part = target.string() + "." + std::to_string(std::random_device()()) + ".part";
  {
    std::ofstream file(part, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues());
    file.close();
    if (!file)
    {
      fs::remove(part, error);
      return "its folder cannot be written to, or the disk is full";
    }
  }
  fs::rename(part, target, error);
  if (error)
  {
    const std::string reason = error.message();
    fs::remove(part, error);
    return reason;
  }
  return "";
}

inline void tell(const char* name, const std::string& path)
{
  std::error_code error;
  std::cout << "<DartMeasurementFile name=\"" << name << "\" type=\"image/png\">"
            << std::filesystem::absolute(path, error).string() << "</DartMeasurementFile>\n";
}

inline bool isUpdating()
{
  const char* value = std::getenv("LAMBENT_UPDATE_BASELINES");
  return value && std::string(value) == "1";
}

/// Make the picture the baseline.
inline int accept(vtkImageData* picture, const std::string& baseline)
{
  const std::string problem = write(picture, baseline);
  if (!problem.empty())
  {
    std::cout << "The picture cannot become the baseline '" << baseline << "': " << problem << "\n";
    return LambentFailed;
  }
  std::cout << "accepted as the baseline '" << baseline << "'\n";
  return LambentPassed;
}

/// Write an image for the user to inspect, and report its path. Never overwrites the baseline.
inline bool leaveBehind(
  vtkImageData* image, const std::string& path, const std::string& baseline, const char* name)
{
  std::string problem = "it is the baseline";
  if (!lambentFiles::isSameFile(path, baseline))
  {
    problem = write(image, path);
  }
  if (!problem.empty())
  {
    std::cout << "'" << path << "' is not written: " << problem << "\n";
    return false;
  }
  tell(name, path);
  return true;
}

/// Write picture and difference, and report their paths.
inline int fail(vtkImageData* picture, vtkLambentImageComparison* comparison,
  const std::string& baseline, const std::string& folder)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const std::string stem = (fs::path(folder) / fs::path(baseline).stem()).string();
  bool isThere = false;
  if (lambentFiles::isSameFile(fs::absolute(folder.empty() ? "." : folder, error).string(),
        fs::absolute(baseline, error).parent_path().string()))
  {
    std::cout << "The picture is not written, since -T names the folder of the baselines; "
              << "choose another one.\n";
  }
  else
  {
    isThere = leaveBehind(picture, stem + ".png", baseline, "TestImage");
    if (comparison->GetOutput()->GetNumberOfPoints() > 0)
    {
      leaveBehind(comparison->GetOutput(), stem + ".diff.png", baseline, "DifferenceImage");
    }
  }
  if (fs::exists(baseline, error))
  {
    tell("ValidImage", baseline);
  }
  if (comparison->GetOutput()->GetNumberOfPoints() > 0)
  {
    std::cout << "<DartMeasurement name=\"ImageError\" type=\"numeric/double\">"
              << comparison->GetMaximumDifference() << "</DartMeasurement>\n";
  }
  if (whyNotPng(picture).empty())
  {
    std::cout << (isThere ? "Look at '" + stem + ".png'; if" : "If")
              << " the picture is right, accept it by running the test with "
              << "LAMBENT_UPDATE_BASELINES=1 in the environment.\n";
  }
  return LambentFailed;
}
}

inline int lambentRegressionTest(
  int argc, char* argv[], vtkImageData* picture, double tolerance = 0.0)
{
  const std::string baseline = lambentRegression::argument(argc, argv, "-V");
  const std::string folder = lambentRegression::argument(argc, argv, "-T");
  if (baseline.empty())
  {
    std::cout << "There is no -V BASELINE among the arguments, so nothing is compared.\n";
    return LambentNotRun;
  }
  if (!picture)
  {
    std::cout << "There is no picture: it is nullptr.\n";
    return LambentFailed;
  }
  vtkNew<vtkLambentImageComparison> comparison;
  vtkNew<vtkLambentPNGReader> reader;
  reader->SetFileName(baseline.c_str());
  std::error_code error;
  if (!std::filesystem::exists(baseline, error))
  {
    std::cout << "There is no baseline '" << baseline << "'.\n";
  }
  else if (!reader->Read())
  {
    std::cout << "The baseline '" << baseline << "' cannot be read: " << reader->GetMessage()
              << "\n";
  }
  else
  {
    comparison->SetPictureData(picture);
    comparison->SetInputConnection(1, reader->GetOutputPort());
    comparison->SetTolerance(tolerance);
    comparison->HighlightOn();
    comparison->Update();
    std::cout << comparison->GetMessage() << "\n";
    if (comparison->GetPassed())
    {
      return LambentPassed;
    }
  }
  return lambentRegression::isUpdating()
    ? lambentRegression::accept(picture, baseline)
    : lambentRegression::fail(picture, comparison, baseline, folder);
}

/// Updates the algorithm and tests its first output.
inline int lambentRegressionTest(
  int argc, char* argv[], vtkAlgorithm* algorithm, double tolerance = 0.0)
{
  if (!algorithm || algorithm->GetNumberOfOutputPorts() == 0)
  {
    std::cout << "There is no picture: the algorithm is nullptr or has no output.\n";
    return LambentFailed;
  }
  // If an input fails, the output keeps its old contents.
  if (!algorithm->GetExecutive()->Update(0))
  {
    std::cout << algorithm->GetClassName() << " could not be updated; see VTK's output.\n";
    return LambentFailed;
  }
  vtkImageData* picture = vtkImageData::SafeDownCast(algorithm->GetOutputDataObject(0));
  if (!picture)
  {
    std::cout << "The output of " << algorithm->GetClassName() << " is not vtkImageData.\n";
    return LambentFailed;
  }
  return lambentRegressionTest(argc, argv, picture, tolerance);
}

#endif
