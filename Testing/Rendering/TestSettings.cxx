// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"
#include "Messages.h"

#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"

#include <sstream>

TEST(Settings, Defaults)
{
  vtkNew<vtkLambentRayTracer> tracer;
  EXPECT_EQ(tracer->GetImageSize()[0], 300);
  EXPECT_EQ(tracer->GetImageSize()[1], 300);
  EXPECT_EQ(tracer->GetSupersampling(), 1);
  EXPECT_EQ(tracer->GetCamera(), nullptr);
  EXPECT_EQ(tracer->GetLights()->GetNumberOfItems(), 0);
  EXPECT_EQ(tracer->GetProperty(), nullptr);
  EXPECT_EQ(tracer->GetInputProperty(0), nullptr);
  EXPECT_EQ(tracer->GetAmbientModel(), vtkLambentRayTracer::PER_LIGHT);
  EXPECT_TRUE(tracer->GetTwoSidedLighting());
  EXPECT_EQ(glm::make_vec3(tracer->GetBackground()), Vec(0.0));
  EXPECT_FALSE(tracer->GetGradientBackground());
  EXPECT_EQ(glm::make_vec3(tracer->GetBackground2()), Vec(0.0));
  EXPECT_EQ(tracer->GetOutputScalarType(), VTK_UNSIGNED_CHAR);
  EXPECT_TRUE(tracer->GetUsePointNormals());
  EXPECT_TRUE(tracer->GetSplitting());
  EXPECT_EQ(tracer->GetFeatureAngle(), 30.0);
  EXPECT_FALSE(tracer->GetGenerateIds());
  EXPECT_FALSE(tracer->GetGenerateDepth());
  EXPECT_FALSE(tracer->GetGenerateNormals());
  EXPECT_FALSE(tracer->GetGeneratePositions());
  EXPECT_FALSE(tracer->GetOutputAlpha());
  EXPECT_EQ(tracer->GetBackgroundImage(), nullptr);
  EXPECT_GE(vtkLambentRayTracer::GetImageContractVersion(), 1);
}

TEST(Settings, AreClampedOrRejected)
{
  vtkNew<vtkLambentRayTracer> tracer;
  Messages messages(tracer);
  tracer->SetAmbientModel(7);
  EXPECT_EQ(tracer->GetAmbientModel(), vtkLambentRayTracer::SCENE);
  EXPECT_TRUE(messages.errors().empty());

  tracer->SetOutputScalarType(VTK_DOUBLE);
  expectMessage(
    messages.errors(), { "SetOutputScalarType", "11", "VTK_UNSIGNED_CHAR", "VTK_FLOAT" });
  EXPECT_EQ(tracer->GetOutputScalarType(), VTK_UNSIGNED_CHAR);
  messages.clear();

  vtkNew<vtkProperty> property;
  tracer->SetInputProperty(-1, property);
  expectMessage(messages.errors(), { "SetInputProperty", "-1", "counted from 0" });
  messages.clear();

  tracer->AddLight(nullptr);
  expectMessage(messages.errors(), { "AddLight" });
  messages.clear();

  tracer->RemoveLight(nullptr);
  vtkNew<vtkLight> stranger;
  tracer->RemoveLight(stranger);
  EXPECT_EQ(tracer->GetLights()->GetNumberOfItems(), 0);
  EXPECT_TRUE(messages.errors().empty());
}

TEST(Settings, ObjectsAreHeldWhileTheyAreSet)
{
  vtkNew<vtkLambentRayTracer> tracer;
  vtkNew<vtkCamera> camera;
  vtkNew<vtkProperty> property;
  vtkNew<vtkLight> light;
  vtkNew<vtkImageData> image;
  const std::vector<vtkObject*> objects{ camera, property, light, image };
  tracer->SetCamera(camera);
  tracer->SetProperty(property);
  tracer->AddLight(light);
  tracer->SetBackgroundImage(image);
  for (vtkObject* object : objects)
  {
    EXPECT_EQ(object->GetReferenceCount(), 2) << object->GetClassName();
  }
  tracer->SetCamera(nullptr);
  tracer->SetProperty(nullptr);
  tracer->RemoveLight(light);
  tracer->SetBackgroundImage(nullptr);
  for (vtkObject* object : objects)
  {
    EXPECT_EQ(object->GetReferenceCount(), 1) << object->GetClassName();
  }
}

// PrintSelf() names every setting, with its value.
TEST(Settings, PrintSelfIsComplete)
{
  vtkNew<vtkLambentRayTracer> tracer;
  tracer->SetImageSize(123, 456);
  tracer->SetBackground(0.125, 0.25, 0.5);
  tracer->SetBackground2(0.75, 0.625, 0.375);
  std::ostringstream text;
  tracer->Print(text);
  for (const char* part :
    { "ImageSize: 123 x 456", "Supersampling: 1", "Camera: (none)", "Lights:", "Property: (none)",
      "AmbientModel: PerLight", "TwoSidedLighting: On", "Background: (0.125, 0.25, 0.5)",
      "GradientBackground: Off", "Background2: (0.75, 0.625, 0.375)",
      "OutputScalarType: unsigned char", "BackgroundImage: (none)", "OutputAlpha: Off",
      "GenerateDepth: Off", "GenerateNormals: Off", "GeneratePositions: Off", "GenerateIds: Off",
      "UsePointNormals: On", "Splitting: On", "FeatureAngle: 30" })
  {
    EXPECT_NE(text.str().find(part), std::string::npos) << part << " in\n" << text.str();
  }
  Studio studio;
  studio.tracer->SetInputProperty(3, studio.property);
  studio.tracer->SetInputTransform(4, vtkNew<vtkMatrix4x4>());
  studio.tracer->SetInputBlockAttributes(5, vtkNew<vtkCompositeDataDisplayAttributes>());
  studio.tracer->SetAmbientModelToScene();
  studio.tracer->TwoSidedLightingOff();
  studio.tracer->GradientBackgroundOn();
  studio.tracer->UsePointNormalsOff();
  studio.tracer->SplittingOff();
  studio.tracer->SetFeatureAngle(45.5);
  studio.camera->SetViewAngle(12.5);
  vtkNew<vtkImageData> image;
  studio.tracer->SetBackgroundImage(image);
  studio.tracer->OutputAlphaOn();
  studio.tracer->GenerateDepthOn();
  studio.tracer->GenerateNormalsOn();
  studio.tracer->GeneratePositionsOn();
  studio.tracer->GenerateIdsOn();
  studio.tracer->AddPassArray(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Heat");
  studio.tracer->AddPassArray(vtkDataObject::FIELD_ASSOCIATION_CELLS, "Part");
  std::ostringstream other;
  studio.tracer->Print(other);
  for (const char* part : { "InputProperty 3:", "InputTransform 4:", "InputBlockAttributes 5:",
         "AmbientModel: Scene", "TwoSidedLighting: Off", "GradientBackground: On",
         "OutputScalarType: float", "UsePointNormals: Off", "Splitting: Off", "FeatureAngle: 45.5",
         "ViewAngle: 12.5", "BackgroundImage: vtkImageData", "OutputAlpha: On", "GenerateDepth: On",
         "GenerateNormals: On", "GeneratePositions: On", "GenerateIds: On",
         "PassArray: point array \"Heat\"", "PassArray: cell array \"Part\"" })
  {
    EXPECT_NE(other.str().find(part), std::string::npos) << part << " in\n" << other.str();
  }
}
