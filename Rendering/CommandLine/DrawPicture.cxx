// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "DrawPicture.h"
#include "Messages.h"
#include "NothingSeen.h"
#include "Passes.h"
#include "Progress.h"
#include "Scene.h"
#include "Stopwatch.h"

#include "vtkLambentRayTracer.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <utility>

namespace lambent::command
{
namespace
{

using Meshes = std::vector<vtkSmartPointer<vtkPolyData>>;

vtkSmartPointer<vtkIdTypeArray> IdsOf(vtkImageData* picture, const char* name)
{
  return vtkIdTypeArray::SafeDownCast(picture->GetPointData()->GetArray(name));
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

void WarnIfNothingIsSeen(const Options& options, const Meshes& meshes, bool areColored,
  vtkImageData* picture, VtkMessages& messages)
{
  std::string reason = options.quiet ? std::string() : WhyNothingIsSeen(options, meshes, picture);
  if (!reason.empty() && areColored)
  {
    // Black materials are no mistake of the options.
    const auto plain = MakeScene(options, meshes);
    plain->Update();
    reason = WhyNothingIsSeen(options, meshes, plain->GetOutput());
  }
  messages.DropWarnings(); // from rendering again to find the reason
  if (!reason.empty())
  {
    Say("warning: " + reason);
  }
}

/// The ray tracer's error, with options instead of methods in its remedy.
std::string InWordsOfOptions(const std::string& error)
{
  for (const auto& [method, option] : { std::pair("Call SetImageSize()", "Choose a smaller --size"),
         std::pair("or call SetInputScalarVisibility() with false", "or give a --color"),
         std::pair("Call SetInputColorArray() with a point array",
           "Choose a point array in --color-by, or omit --spheres"),
         std::pair("Call vtkCamera::SetViewUp()", "Choose another --view-up"),
         std::pair("Move one of them with vtkCamera", "Move --camera-position or --focal-point") })
  {
    const std::size_t remedy = error.find(method);
    if (remedy != std::string::npos)
    {
      return error.substr(0, remedy) + option;
    }
  }
  return error.empty() ? "the picture is empty" : error;
}

} // namespace

Drawing DrawPicture(const Options& options, const Meshes& meshes,
  const std::vector<MeshLooks>& looks, vtkImageData* background, VtkMessages& messages,
  Progress& progress, Stopwatch& stopwatch)
{
  progress.Begin("rendering");
  const MaterialInputs inputs(meshes, looks);
  const auto tracer = MakeScene(options, inputs.Inputs());
  inputs.Apply(options, tracer);
  tracer->SetBackgroundImage(background);
  RequestPasses(options.passes, meshes, tracer);
  LapNormals(tracer, stopwatch);
  const bool isCompared = !options.comparison.baseline.empty();
  tracer->SetGenerateIds(tracer->GetGenerateIds() || isCompared);
  progress.Follow(tracer);
  tracer->Update();
  const std::string error = messages.TakeError();
  if (!error.empty() || tracer->GetOutput()->GetNumberOfPoints() == 0)
  {
    throw Failure("cannot render: " + InWordsOfOptions(error));
  }
  progress.Erase();
  messages.FlushWarnings("");
  vtkImageData* const picture = tracer->GetOutput();
  inputs.RestoreIds(picture);
  WarnIfNothingIsSeen(options, meshes, inputs.AreColored(), picture, messages);
  PixelIds ids;
  if (isCompared)
  {
    ids = { IdsOf(picture, "CellIds"), IdsOf(picture, "InputIds") };
  }
  KeepOnlyPasses(options.passes, picture);
  return { picture, ids };
}

} // namespace lambent::command
