// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the command `lambent`, which renders mesh files into a picture
 */

#include "CheckPolygons.h"
#include "Compare.h"
#include "CoverWithTexture.h"
#include "DataColors.h"
#include "DrawPicture.h"
#include "FileKinds.h"
#include "IdleOptions.h"
#include "ListFile.h"
#include "Messages.h"
#include "Options.h"
#include "Passes.h"
#include "Progress.h"
#include "ProtectFiles.h"
#include "ReadBackground.h"
#include "ReadPicture.h"
#include "ReadSurface.h"
#include "Recipe.h"
#include "Stopwatch.h"
#include "WritePicture.h"

#include "vtkLambentRayTracer.h"

#include "vtkImageData.h"
#include "vtkNew.h"
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

/// Also reads the looks of each mesh.
Meshes ReadMeshes(
  const Options& options, std::vector<MeshLooks>& looks, VtkMessages& messages, Progress& progress)
{
  std::optional<ContourValue> contour = options.contour;
  if (contour)
  {
    contour->keepsArrays = !options.passes.empty() || !options.colors.array.empty() ||
      options.spheres || !options.texture.empty();
  }
  Meshes meshes;
  for (const std::string& path : options.inputs)
  {
    meshes.push_back(ReadSurface(path, messages, progress, contour, options.spheres.has_value()));
    looks.push_back(
      ShowsMaterials(options) ? ReadLooks(meshes.back(), path, messages, progress) : MeshLooks());
    progress.Erase();
    messages.FlushWarnings("'" + path + "': ");
  }
  return meshes;
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
  const auto whole = [](const std::string& path)
  { return std::filesystem::absolute(path).lexically_normal().string(); };
  const std::string picture = options.output.empty() ? "not written"
    : options.output == "-"                          ? "standard output"
                                                     : whole(options.output);
  std::fprintf(stderr, "picture    %s\n", picture.c_str());
  for (const PassValue& pass : options.passes)
  {
    if (!pass.file.empty())
    {
      std::fprintf(stderr, "pass       %s in %s\n", pass.text.c_str(), whole(pass.file).c_str());
    }
  }
  std::fprintf(stderr, "size       %d x %d\n", (*options.size)[0], (*options.size)[1]);
  std::fprintf(
    stderr, "samples    %d x %d per pixel\n", *options.supersampling, *options.supersampling);
  std::fprintf(stderr, "triangles  %lld\n", static_cast<long long>(triangles));
  const std::string colors = DescribeColors(options, meshes);
  if (!colors.empty())
  {
    std::fprintf(stderr, "colours    %s\n", colors.c_str());
  }
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

/// Throws Failure if a picture or a pass cannot be written, before anything is rendered.
void CheckPlaces(const Options& options)
{
  if (!options.output.empty())
  {
    const std::string reason = options.alpha ? WhyNoAlpha(options.output) : "";
    if (!reason.empty()) // CheckFilm() did not see the options of a recreated picture
    {
      throw Failure(reason);
    }
    CheckPicturePlace(options.output);
  }
  for (const PassValue& pass : options.passes)
  {
    if (!pass.file.empty())
    {
      CheckPicturePlace(pass.file);
    }
  }
}

/// Renders, and writes and compares if requested. Returns false if the comparison failed.
bool Draw(Options options, VtkMessages& messages)
{
  Progress progress(!options.quiet);
  UseThreads(options.threads);
  CheckPlaces(options);
  options.size = SizeOf(options, messages);
  options.supersampling = SupersamplingOf(options);

  Stopwatch stopwatch;
  std::vector<MeshLooks> looks;
  const Meshes meshes = ReadMeshes(options, looks, messages, progress);
  vtkSmartPointer<vtkImageData> background;
  if (!options.backgroundImage.empty())
  {
    background = ReadBackground(options.backgroundImage, messages, progress);
  }
  DropIdleOptions(options, meshes, looks, background);
  if (!options.texture.empty())
  {
    looks = CoverWithTexture(options, meshes, messages, progress);
  }
  stopwatch.Lap("reading");
  const Drawing drawing =
    DrawPicture(options, meshes, looks, background, messages, progress, stopwatch);
  stopwatch.Lap("rendering");
  if (!options.output.empty())
  {
    progress.Begin("writing " + options.output);
    WritePicture(drawing.picture, options.output, messages, DescribeDrawing(options));
  }
  WritePasses(options.passes, drawing.picture, meshes, messages, progress);
  if (!options.output.empty() || !options.passes.empty())
  {
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

/// Prints what the inputs hold.
void List(const Options& options, VtkMessages& messages)
{
  Progress progress(!options.quiet);
  for (const std::string& path : options.inputs)
  {
    const std::string listing = ListFile(path, messages, progress);
    progress.Erase();
    messages.FlushWarnings("'" + path + "': ");
    std::fputs((&path == &options.inputs.front() ? "" : "\n"), stdout);
    std::fputs(listing.c_str(), stdout);
  }
}

bool Run(const Options& options)
{
  VtkMessages messages(!options.quiet);
  if (options.list)
  {
    List(options, messages);
    return true;
  }
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
  catch (const WrongUsage& error)
  {
    Say(OneLine(error.what()));
    std::fputs("Try 'lambent --help'.\n", stderr);
    return 2;
  }
  catch (const std::exception& error) // a Failure; anything else is most likely out of memory
  {
    Say(OneLine(error.what()));
    return 1;
  }
}
