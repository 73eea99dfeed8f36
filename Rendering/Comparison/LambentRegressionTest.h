// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief for tests in the manner of vtkTesting: arguments -V and -T, tags for CDash
 *
 *     int TestPicture(int argc, char* argv[])
 *     {
 *       vtkNew<vtkLambentRayTracer> tracer;
 *       ...
 *       return !lambentRegressionTest(argc, argv, tracer.Get());
 *     }
 *
 * stands where vtkRegressionTestImage() or vtkTesting::RegressionTest() stood, takes
 * the arguments that these take, and returns what they return:
 *
 *     -V BASELINE   the PNG file that the picture must be
 *     -T FOLDER     where the picture and the difference are written if it is not [.]
 *
 * Unlike those it is exact unless it is given a tolerance, in units of the scalars, and
 * knows no alternative baselines. With LAMBENT_UPDATE_BASELINES=1 in the
 * environment a picture that differs becomes the baseline.
 *
 * Link Lambent::Lambent and VTK::IOImage.
 */

#ifndef LambentRegressionTest_h
#define LambentRegressionTest_h

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkLambentImageComparison.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

/// As vtkTesting has them, of which LambentNotRun is for a test without -V.
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

inline void write(vtkImageData* image, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->Write();
}

inline void tell(const char* name, const std::string& path)
{
  std::cout << "<DartMeasurementFile name=\"" << name << "\" type=\"image/png\">"
            << std::filesystem::absolute(path).string() << "</DartMeasurementFile>\n";
}

inline bool isUpdating()
{
  const char* value = std::getenv("LAMBENT_UPDATE_BASELINES");
  return value && std::string(value) == "1";
}

/// Leave picture and difference behind, and name them.
inline int fail(vtkImageData* picture, vtkLambentImageComparison* comparison,
  const std::string& baseline, const std::string& folder)
{
  namespace fs = std::filesystem;
  if (isUpdating() && picture->GetNumberOfPoints() > 0)
  {
    fs::create_directories(fs::absolute(baseline).parent_path());
    write(picture, baseline);
    std::cout << "accepted as the baseline '" << baseline << "'\n";
    return LambentPassed;
  }
  const std::string stem = (fs::path(folder) / fs::path(baseline).stem()).string();
  if (picture->GetNumberOfPoints() > 0)
  {
    write(picture, stem + ".png");
    tell("TestImage", stem + ".png");
  }
  if (fs::exists(baseline))
  {
    tell("ValidImage", baseline);
  }
  if (comparison->GetOutput()->GetNumberOfPoints() > 0)
  {
    write(comparison->GetOutput(), stem + ".diff.png");
    tell("DifferenceImage", stem + ".diff.png");
    std::cout << "<DartMeasurement name=\"ImageError\" type=\"numeric/double\">"
              << comparison->GetMaximumDifference() << "</DartMeasurement>\n";
  }
  std::cout << "Look at '" << stem << ".png'; if it is right, accept it by running the test with "
            << "LAMBENT_UPDATE_BASELINES=1 in the environment.\n";
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
  vtkNew<vtkLambentImageComparison> comparison;
  if (!std::filesystem::exists(baseline))
  {
    std::cout << "There is no baseline '" << baseline << "'.\n";
    return lambentRegression::fail(picture, comparison, baseline, folder);
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(baseline.c_str());
  comparison->SetPictureData(picture);
  comparison->SetInputConnection(1, reader->GetOutputPort());
  comparison->SetTolerance(tolerance);
  comparison->HighlightOn();
  comparison->Update();
  std::cout << comparison->GetMessage() << "\n";
  return comparison->GetPassed() ? LambentPassed
                                 : lambentRegression::fail(picture, comparison, baseline, folder);
}

/// The first output of an algorithm, brought up to date.
inline int lambentRegressionTest(
  int argc, char* argv[], vtkAlgorithm* algorithm, double tolerance = 0.0)
{
  algorithm->Update();
  vtkImageData* picture = vtkImageData::SafeDownCast(algorithm->GetOutputDataObject(0));
  if (!picture)
  {
    std::cout << "The output of " << algorithm->GetClassName() << " is not vtkImageData.\n";
    return LambentFailed;
  }
  return lambentRegressionTest(argc, argv, picture, tolerance);
}

#endif
