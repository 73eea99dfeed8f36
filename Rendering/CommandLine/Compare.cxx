// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Compare.h"
#include "FileBytes.h"
#include "FileKinds.h"
#include "Messages.h"
#include "ReadPicture.h"
#include "Recipe.h"
#include "ReportFile.h"
#include "ReportSection.h"
#include "TemporaryFile.h"
#include "WritePicture.h"

#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkLambentImageComparison.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace lambent::command
{
namespace
{

namespace fs = std::filesystem;

bool IsSet(const char* variable)
{
  const char* const value = std::getenv(variable);
  return value && std::string(value) == "1";
}

/// CTest sets the first variable in every run, and the second when it reports to CDash. Not every
/// version sets both.
bool IsUnderCTest()
{
  return std::getenv("CTEST_INTERACTIVE_DEBUG_MODE") || std::getenv("DASHBOARD_TEST_FROM_CTEST");
}

bool Exists(const std::string& path)
{
  std::error_code error;
  return fs::exists(path, error);
}

/// Compares. There is no difference image without a baseline or if the sizes differ.
Verdict Judge(
  vtkImageData* picture, const PixelIds& ids, const Options& options, VtkMessages& messages)
{
  Verdict verdict;
  verdict.picture = picture;
  verdict.inputs = options.inputs;
  if (!Exists(options.comparison.baseline))
  {
    verdict.message = "there is no baseline '" + options.comparison.baseline + "'";
    return verdict;
  }
  verdict.baseline = ReadPicture(options.comparison.baseline, messages);

  vtkNew<vtkLambentImageComparison> comparison;
  comparison->SetInputData(0, verdict.picture);
  comparison->SetInputData(1, verdict.baseline);
  comparison->SetMetric(static_cast<int>(options.comparison.metric));
  comparison->SetTolerance(options.comparison.tolerance);
  comparison->HighlightOn();
  comparison->Update();
  const std::string error = messages.TakeError();
  if (!error.empty())
  {
    throw Failure("cannot compare: " + error);
  }
  verdict.passed = comparison->GetPassed();
  verdict.message = comparison->GetMessage();
  if (comparison->GetOutput()->GetNumberOfPoints() > 0)
  {
    verdict.difference = comparison->GetOutput();
    if (ids.cells && !verdict.passed)
    {
      verdict.cells = FindChangedCells(verdict.difference, ids);
    }
  }
  return verdict;
}

/// Makes the picture the baseline. An existing file of the same kind is copied byte for byte.
void Accept(vtkImageData* picture, const Options& options, VtkMessages& messages)
{
  const std::string& baseline = options.comparison.baseline;
  std::error_code error; // ignored: if the folder cannot be made, writing fails
  fs::create_directories(fs::absolute(baseline).parent_path(), error);
  if (!options.picture.empty() && PictureKindOf(options.picture) == PictureKindOf(baseline))
  {
    const FileBytes bytes(options.picture);
    TemporaryFile file(baseline);
    file.Write(bytes.begin(), bytes.size());
    file.Commit();
    return;
  }
  // Baselines are shared, and absolute paths mean nothing on other machines.
  const auto isAbsolute = [](const std::string& path) { return fs::path(path).is_absolute(); };
  const bool isPortable = !isAbsolute(options.backgroundImage) &&
    std::none_of(options.inputs.begin(), options.inputs.end(), isAbsolute);
  WritePicture(picture, baseline, messages, isPortable ? DescribeDrawing(options) : PictureText());
}

void PrintMeasurement(const char* name, const std::string& path)
{
  if (PictureKindOf(path) == PictureKind::Png && Exists(path))
  {
    std::printf("<DartMeasurementFile name=\"%s\" type=\"image/png\">%s</DartMeasurementFile>\n",
      name, fs::absolute(path).lexically_normal().c_str());
  }
}

/// For CDash, under the names that it shows side by side.
void PrintMeasurements(const Options& options, const Verdict& verdict)
{
  PrintMeasurement("TestImage", options.picture.empty() ? options.output : options.picture);
  PrintMeasurement("ValidImage", options.comparison.baseline);
  if (verdict.difference)
  {
    PrintMeasurement("DifferenceImage", options.comparison.difference);
  }
}

std::string HowToAccept(const Options& options)
{
  const std::string& picture = options.picture.empty() ? options.output : options.picture;
  return (picture.empty() || picture == "-"
             ? "if it is intended, accept it"
             : "look at '" + picture + "'; if it is right, accept it") +
    " by running this again with LAMBENT_UPDATE_BASELINES=1 in the environment" +
    (IsUnderCTest() ? ", or by building the target lambent-update-baselines" : "");
}

void Tell(const Options& options, const Verdict& verdict)
{
  std::FILE* const stream = options.output == "-" ? stderr : stdout;
  const auto say = [stream](const std::string& line) { std::fputs((line + "\n").c_str(), stream); };
  if (verdict.passed && options.quiet)
  {
    return;
  }
  say(verdict.message);
  if (!verdict.cells.empty())
  {
    say("the changed pixels show " + Describe(verdict.cells, verdict.inputs));
  }
  if (!verdict.passed && (!verdict.baseline || IsUnderCTest()))
  {
    say(HowToAccept(options));
  }
}

std::string NameOf(const Options& options)
{
  for (const std::string* name : { &options.comparison.name, &options.picture, &options.output })
  {
    if (!name->empty() && *name != "-")
    {
      return *name;
    }
  }
  return options.comparison.baseline;
}

} // namespace

bool Compare(
  vtkImageData* picture, const PixelIds& ids, const Options& options, VtkMessages& messages)
{
  const ComparisonOptions& how = options.comparison;
  Verdict verdict = Judge(picture, ids, options, messages);
  if (!verdict.passed && IsSet("LAMBENT_UPDATE_BASELINES"))
  {
    Accept(picture, options, messages);
    verdict.passed = true;
    verdict.message = "accepted as the baseline '" + how.baseline + "'";
    verdict.cells.clear();
  }
  if (!how.difference.empty() && verdict.difference)
  {
    WritePicture(verdict.difference, how.difference, messages);
  }
  if (!how.report.empty())
  {
    AddToReport(how.report, NameOf(options), DescribeInHtml(NameOf(options), verdict, messages));
  }
  Tell(options, verdict);
  if (!verdict.passed && IsUnderCTest())
  {
    PrintMeasurements(options, verdict);
  }
  return verdict.passed;
}

} // namespace lambent::command
