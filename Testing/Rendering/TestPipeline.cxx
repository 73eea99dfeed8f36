// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// When a picture is rendered again, and what that changes in the pipeline around it.
#include "Meshes.h"
#include "Messages.h"

#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkSphereSource.h"

#include <functional>

namespace
{
/// Counts the executions of a filter.
class Executions
{
public:
  explicit Executions(vtkAlgorithm* filter)
  {
    this->OnEnd->SetClientData(&this->Count);
    this->OnEnd->SetCallback(
      [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    filter->AddObserver(vtkCommand::EndEvent, this->OnEnd);
  }
  int count() const { return this->Count; }

private:
  int Count = 0;
  vtkNew<vtkCallbackCommand> OnEnd;
};
}

TEST(Pipeline, RendersAgainExactlyWhenSomethingHasChanged)
{
  Studio studio;
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkLight> light;
  vtkNew<vtkMatrix4x4> matrix;
  vtkNew<vtkProperty> own;
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  image->GetPointData()->GetScalars()->Fill(100.0);
  light->SetLightTypeToSceneLight();
  light->SetTransformMatrix(matrix);
  vtkLambentRayTracer* tracer = studio.tracer;
  tracer->AddInputConnection(sphere->GetOutputPort());
  tracer->AddInputConnection(sphere->GetOutputPort());
  tracer->AddLight(light);
  tracer->SetInputProperty(1, own);

  const std::vector<std::pair<const char*, std::function<void()>>> changes{
    { "camera", [&]() { studio.camera->Azimuth(10.0); } },
    { "light", [&]() { light->SetIntensity(0.5); } },
    { "light's matrix", [&]() { matrix->SetElement(0, 3, 1.0); } },
    { "lights", [&]() { tracer->GetLights()->AddItem(light); } },
    { "light taken away", [&]() { tracer->RemoveLight(light); } },
    { "light added", [&]() { tracer->AddLight(light); } },
    { "all lights taken away", [&]() { tracer->RemoveAllLights(); } },
    { "property", [&]() { studio.property->SetAmbient(0.2); } },
    { "input's property", [&]() { own->SetDiffuse(0.2); } },
    { "another property", [&]() { tracer->SetProperty(own); } },
    { "input without property", [&]() { tracer->SetInputProperty(1, nullptr); } },
    { "another camera", [&]() { tracer->SetCamera(nullptr); } },
    { "input", [&]() { sphere->SetThetaResolution(20); } },
    { "another input", [&]() { tracer->SetInputDataObject(0, makeSquare()); } },
    { "ImageSize", [&]() { tracer->SetImageSize(20, 20); } },
    { "AmbientModel", [&]() { tracer->SetAmbientModelToScene(); } },
    { "TwoSidedLighting", [&]() { tracer->TwoSidedLightingOff(); } },
    { "Background", [&]() { tracer->SetBackground(0.1, 0.2, 0.3); } },
    { "GradientBackground", [&]() { tracer->GradientBackgroundOn(); } },
    { "Background2", [&]() { tracer->SetBackground2(0.1, 0.2, 0.3); } },
    { "OutputScalarType", [&]() { tracer->SetOutputScalarTypeToUnsignedChar(); } },
    { "BackgroundImage", [&]() { tracer->SetBackgroundImage(image); } },
    { "the background image", [&]() { image->GetPointData()->GetScalars()->Modified(); } },
    { "no BackgroundImage", [&]() { tracer->SetBackgroundImage(nullptr); } },
    { "OutputAlpha", [&]() { tracer->OutputAlphaOn(); } },
    { "GenerateDepth", [&]() { tracer->GenerateDepthOn(); } },
    { "GenerateNormals", [&]() { tracer->GenerateNormalsOn(); } },
    { "GeneratePositions", [&]() { tracer->GeneratePositionsOn(); } },
    { "GenerateIds", [&]() { tracer->GenerateIdsOn(); } },
    { "PassArray", [&]() { tracer->AddPassArray(0, "Heat"); } },
    { "no PassArray", [&]() { tracer->RemoveAllPassArrays(); } },
    { "UsePointNormals", [&]() { tracer->UsePointNormalsOff(); } },
    { "FeatureAngle", [&]() { tracer->SetFeatureAngle(15.0); } },
    { "Splitting", [&]() { tracer->SplittingOff(); } },
  };
  const Executions executions(tracer);
  tracer->Update();
  int expected = 1;
  EXPECT_EQ(executions.count(), expected);
  for (const auto& change : changes)
  {
    tracer->Update();
    EXPECT_EQ(executions.count(), expected) << "before: " << change.first;
    change.second();
    tracer->Update();
    EXPECT_EQ(executions.count(), ++expected) << change.first;
  }
}

// Setting a value again is not a change.
TEST(Pipeline, SameSettingsAreNoChange)
{
  Studio studio;
  studio.tracer->SetInputData(makeSquare());
  const Executions executions(studio.tracer);
  studio.tracer->Update();
  studio.tracer->SetCamera(studio.camera);
  studio.tracer->SetProperty(studio.property);
  studio.tracer->SetImageSize(32, 24);
  studio.tracer->SetBackground(-1.0, -2.0, -3.0);
  studio.tracer->SetOutputScalarTypeToFloat();
  studio.tracer->SetBackgroundImage(nullptr);
  studio.tracer->OutputAlphaOff();
  studio.tracer->GenerateDepthOff();
  studio.tracer->RemoveAllPassArrays();
  studio.tracer->Update();
  EXPECT_EQ(executions.count(), 1);
}

// Rendering modifies neither the inputs nor the caller's other objects.
TEST(Pipeline, DoesNotModifyTheCallersObjects)
{
  Studio studio;
  vtkNew<vtkLight> light;
  studio.tracer->AddLight(light);
  const Mesh meshes[] = { makeSphere(6), makeBox(0.5, 0.5, 0.5), makeSquare(0.25) };
  meshes[1]->GetPointData()->SetNormals(nullptr); // the filter computes them
  for (const Mesh& mesh : meshes)
  {
    studio.tracer->AddInputDataObject(mesh);
  }
  const auto times = [&]()
  {
    std::vector<vtkMTimeType> result{ light->GetMTime(), studio.camera->GetMTime(),
      studio.property->GetMTime(), studio.tracer->GetMTime() };
    for (const Mesh& mesh : meshes)
    {
      result.push_back(mesh->GetMTime());
      result.push_back(mesh->GetPoints()->GetMTime());
      result.push_back(mesh->GetPolys()->GetMTime());
      result.push_back(mesh->GetPointData()->GetMTime());
      result.push_back(mesh->GetCellData()->GetMTime());
      result.push_back(mesh->GetPointData()->GetNumberOfArrays());
      result.push_back(mesh->GetCellData()->GetNumberOfArrays());
      result.push_back(mesh->GetReferenceCount());
    }
    return result;
  };
  const auto before = times();
  studio.tracer->Update();
  studio.tracer->Modified();
  studio.tracer->Update();
  const auto after = times();
  for (std::size_t k = 0; k < before.size(); ++k)
  {
    if (k != 3) // the tracer's own
    {
      EXPECT_EQ(after[k], before[k]) << "number " << k;
    }
  }
}

TEST(Pipeline, OutputIsAnImageWithColours)
{
  Studio studio(31, 17);
  studio.tracer->SetInputData(makeSquare());
  studio.tracer->UpdateInformation();
  vtkImageData* output = studio.tracer->GetOutput();
  for (int type : { VTK_FLOAT, VTK_UNSIGNED_CHAR })
  {
    studio.tracer->SetOutputScalarType(type);
    studio.tracer->Update();
    const int expected[6] = { 0, 30, 0, 16, 0, 0 };
    for (int k = 0; k < 6; ++k)
    {
      EXPECT_EQ(output->GetExtent()[k], expected[k]);
    }
    EXPECT_EQ(glm::make_vec3(output->GetSpacing()), Vec(1.0));
    EXPECT_EQ(glm::make_vec3(output->GetOrigin()), Vec(0.0));
    EXPECT_EQ(output->GetScalarType(), type);
    EXPECT_EQ(output->GetNumberOfScalarComponents(), 3);
    ASSERT_NE(output->GetPointData()->GetScalars(), nullptr);
    EXPECT_STREQ(output->GetPointData()->GetScalars()->GetName(), "Color");
    EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 1);
  }
}

// A picture that was passed on stays unchanged when the next one is rendered.
TEST(Pipeline, PicturesDoNotShareMemory)
{
  Studio studio;
  studio.tracer->SetInputData(makeSphere(6));
  studio.tracer->Update();
  vtkNew<vtkImageData> kept;
  kept->ShallowCopy(studio.tracer->GetOutput());
  const Picture before(kept);
  studio.camera->Azimuth(30.0);
  studio.tracer->Update();
  EXPECT_EQ(Picture(kept).bits(), before.bits());
}

TEST(Pipeline, OrderOfInputsDoesNotMatter)
{
  const Mesh a = makeSphere(9), b = makeBox(0.8, 0.9, 0.7), c = makeCylinder(7);
  const auto picture = [](const std::vector<vtkPolyData*>& meshes)
  {
    Studio studio;
    studio.look({ 3.0, 2.0, 4.0 }, { 0.0, 0.0, 0.0 });
    for (vtkPolyData* mesh : meshes)
    {
      studio.tracer->AddInputDataObject(mesh);
    }
    return render(studio.tracer);
  };
  const Picture first = picture({ a, b, c });
  EXPECT_SAME_BITS(first, picture({ c, a, b }));
  EXPECT_SAME_BITS(first, picture({ b, c, a }));
  EXPECT_NE(first.bits(), picture({ a, b }).bits());
}
