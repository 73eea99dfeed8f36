// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the command `lambent`, which renders mesh files into a picture
 */

#include "CheckPolygons.h"
#include "Compare.h"
#include "IdleFeatureAngle.h"
#include "Messages.h"
#include "NothingSeen.h"
#include "Options.h"
#include "Progress.h"
#include "ProtectFiles.h"
#include "ReadPicture.h"
#include "ReadSurface.h"
#include "Recipe.h"
#include "Scene.h"
#include "Stopwatch.h"
#include "WritePicture.h"

#include "vtkLambentRayTracer.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkVersion.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <thread>

namespace
{

using namespace lambent::command;
using Meshes = std::vector<vtkSmartPointer<vtkPolyData>>;

Meshes ReadMeshes(const Options& options, VtkMessages& messages, Progress& progress)
{
  Meshes meshes;
  for (const std::string& path : options.inputs)
  {
    meshes.push_back(ReadSurface(path, messages, progress, options.contour));
    progress.Erase();
    messages.FlushWarnings("'" + path + "': ");
  }
  return meshes;
}

/// Warns if the feature angle has no effect, and drops it: the ray tracer's own warning would name
/// methods instead of options.
void DropIdleFeatureAngle(Options& options, const Meshes& meshes)
{
  const std::string reason = WhyFeatureAngleIsIdle(options, meshes);
  if (!reason.empty())
  {
    options.featureAngle.reset();
    if (!options.quiet)
    {
      Say("warning: " + reason);
    }
  }
}

/// A picture and, for a comparison, the ids of its pixels.
struct Drawing
{
  vtkSmartPointer<vtkImageData> picture;
  PixelIds ids;
};

vtkSmartPointer<vtkIdTypeArray> TakeIds(vtkImageData* picture, const char* name)
{
  const vtkSmartPointer<vtkIdTypeArray> ids =
    vtkIdTypeArray::SafeDownCast(picture->GetPointData()->GetArray(name));
  picture->GetPointData()->RemoveArray(name);
  return ids;
}

/// Records the time of the first of the ray tracer's two stages, "normals" and "rendering".
void LapNormals(vtkLambentRayTracer* tracer, Stopwatch& stopwatch)
{
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&stopwatch);
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* clock, void*)
    {
      auto& stopwatch = *static_cast<Stopwatch*>(clock);
      const char* const stage = static_cast<vtkAlgorithm*>(caller)->GetProgressText();
      if (stage && std::string(stage) == "rendering" &&
        stopwatch.GetLaps().back().first != "normals")
      {
        stopwatch.Lap("normals");
      }
    });
  tracer->AddObserver(vtkCommand::ProgressEvent, observer);
}

void WarnIfNothingIsSeen(
  const Options& options, const Meshes& meshes, vtkImageData* picture, VtkMessages& messages)
{
  const std::string reason =
    options.quiet ? std::string() : WhyNothingIsSeen(options, meshes, picture);
  messages.DropWarnings(); // from rendering again to find the reason
  if (!reason.empty())
  {
    Say("warning: " + reason);
  }
}

Drawing Render(const Options& options, const Meshes& meshes, VtkMessages& messages,
  Progress& progress, Stopwatch& stopwatch)
{
  progress.Begin("rendering");
  const auto tracer = MakeScene(options, meshes);
  LapNormals(tracer, stopwatch);
  tracer->SetGenerateIds(!options.comparison.baseline.empty());
  progress.Follow(tracer);
  tracer->Update();
  const std::string error = messages.TakeError();
  if (!error.empty() || tracer->GetOutput()->GetNumberOfPoints() == 0)
  {
    throw Failure("cannot render: " + (error.empty() ? "the picture came out empty" : error));
  }
  progress.Erase();
  messages.FlushWarnings("");
  vtkImageData* const picture = tracer->GetOutput();
  WarnIfNothingIsSeen(options, meshes, picture, messages);
  return { picture, { TakeIds(picture, "CellIds"), TakeIds(picture, "InputIds") } };
}

/// The size in the options, or else the baseline's.
std::array<int, 2> SizeOf(const Options& options, VtkMessages& messages)
{
  if (options.size)
  {
    return *options.size;
  }
  const std::string& baseline = options.comparison.baseline;
  std::error_code error;
  if (!baseline.empty() && std::filesystem::exists(baseline, error))
  {
    const auto picture = ReadPicture(baseline, messages); // owns the dimensions
    const int* const size = picture->GetDimensions();
    return { size[0], size[1] };
  }
  return { 1920, 1080 };
}

/// As many as the options say, or else as the baseline has.
int SupersamplingOf(const Options& options)
{
  const std::string& baseline = options.comparison.baseline;
  std::error_code error;
  return options.supersampling ? *options.supersampling
    : !baseline.empty() && std::filesystem::exists(baseline, error)
    ? RecordedSupersampling(baseline)
    : DefaultSupersampling;
}

void Report(const Options& options, const Meshes& meshes, const Stopwatch& stopwatch)
{
  vtkIdType triangles = 0;
  for (vtkPolyData* mesh : meshes)
  {
    triangles += CountTriangles(mesh);
  }
  const std::string picture = options.output.empty() ? "not written"
    : options.output == "-"                          ? "standard output"
                            : std::filesystem::absolute(options.output).lexically_normal().string();
  std::fprintf(stderr, "picture    %s\n", picture.c_str());
  std::fprintf(stderr, "size       %d x %d\n", (*options.size)[0], (*options.size)[1]);
  std::fprintf(
    stderr, "samples    %d x %d per pixel\n", *options.supersampling, *options.supersampling);
  std::fprintf(stderr, "triangles  %lld\n", static_cast<long long>(triangles));
  for (const auto& [stage, milliseconds] : stopwatch.GetLaps())
  {
    std::fprintf(stderr, "%-10s %.1f ms\n", stage.c_str(), milliseconds);
  }
}

void UseThreads(int count)
{
  if (count > 0)
  {
    // More threads than the machine runs at once gain nothing and make TBB warn.
    const int most = static_cast<int>(std::thread::hardware_concurrency());
    vtkSMPTools::Initialize(most > 0 ? std::min(count, most) : count);
  }
}

/// Renders, and writes and compares if requested. Returns false if the comparison failed.
bool Draw(Options options, VtkMessages& messages)
{
  Progress progress(!options.quiet);
  UseThreads(options.threads);
  if (!options.output.empty())
  {
    CheckPicturePlace(options.output);
  }
  options.size = SizeOf(options, messages);
  options.supersampling = SupersamplingOf(options);

  Stopwatch stopwatch;
  const Meshes meshes = ReadMeshes(options, messages, progress);
  DropIdleFeatureAngle(options, meshes);
  stopwatch.Lap("reading");
  const Drawing drawing = Render(options, meshes, messages, progress, stopwatch);
  stopwatch.Lap("rendering");
  if (!options.output.empty())
  {
    progress.Begin("writing " + options.output);
    WritePicture(drawing.picture, options.output, messages, DescribeDrawing(options));
    stopwatch.Lap("writing");
  }
  progress.Erase();
  bool passed = true;
  if (!options.comparison.baseline.empty())
  {
    passed = Compare(drawing.picture, drawing.ids, options, messages);
    stopwatch.Lap("comparing");
  }
  if (options.verbose)
  {
    Report(options, meshes, stopwatch);
  }
  return passed;
}

bool Run(const Options& options)
{
  VtkMessages messages(!options.quiet);
  const Options all = options.recreate.empty() ? options : ReadRecipe(options);
  ProtectFiles(all);
  if (!all.picture.empty())
  {
    return Compare(ReadPicture(all.picture, messages), PixelIds(), all, messages);
  }
  return Draw(all, messages);
}

std::string Version()
{
  return std::string("lambent ") + LAMBENT_VERSION + " (image contract " +
    std::to_string(vtkLambentRayTracer::GetImageContractVersion()) + ", VTK " +
    vtkVersion::GetVTKVersion() + ")";
}

} // namespace

int main(int argc, char* argv[])
{
  const Parsed parsed = ParseOptions(argc, argv, Version());
  if (parsed.exitStatus)
  {
    std::fputs(parsed.standardOutput.c_str(), stdout);
    std::fputs(parsed.standardError.c_str(), stderr);
    return *parsed.exitStatus;
  }
  try
  {
    return Run(parsed.options) ? 0 : 1;
  }
  catch (const std::exception& error) // a Failure; anything else is most likely out of memory
  {
    Say(OneLine(error.what()));
    return 1;
  }
}
