// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Textures that cannot be used are errors that name the input and the remedy. Settings without
// effect are warnings.
#include "ExpectedErrors.h"
#include "TexturedQuad.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageFlip.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTransform.h"

namespace
{
using ChangeQuad = std::function<void(TexturedQuad&)>;

/// The messages of a picture after a change of a valid scene.
void expectTextureError(const ChangeQuad& spoil, const std::vector<std::string>& parts)
{
  SCOPED_TRACE(parts.front());
  TexturedQuad scene(4, 3);
  Messages messages(scene.tracer);
  scene.texture->SetInputData(makeImage(4, 3, 3));
  scene.tracer->Update();
  EXPECT_TRUE(messages.errors().empty());
  spoil(scene);
  scene.tracer->Update();
  expectMessage(messages.errors(), parts);
  EXPECT_EQ(scene.tracer->GetOutput()->GetNumberOfPoints(), 0);
  scene.tracer->SetInputTexture(0, nullptr);
  messages.clear();
  scene.tracer->Update();
  EXPECT_EQ(messages.errors(), std::vector<std::string>());
  EXPECT_EQ(scene.tracer->GetOutput()->GetNumberOfPoints(), 12);
}

void expectIdle(const ChangeQuad& change, const std::vector<std::string>& parts)
{
  TexturedQuad scene(4, 3);
  Messages messages(scene.tracer);
  scene.texture->SetInputData(makeImage(4, 3, 3));
  change(scene);
  scene.tracer->Update();
  EXPECT_EQ(messages.errors(), std::vector<std::string>());
  expectMessage(messages.warnings(), parts);
}
}

TEST(BadTextures, Coordinates)
{
  expectTextureError([](TexturedQuad& scene) { scene.quad->GetPointData()->SetTCoords(nullptr); },
    { "Input 0: it has no texture coordinates", "vtkTextureMapToPlane", "SetInputTexture()" });
  expectTextureError(
    [](TexturedQuad& scene)
    {
      scene.quad->GetPointData()->GetTCoords()->SetNumberOfTuples(3);
      scene.quad->Modified();
    },
    { "Input 0", "\"Places\"", "3 tuples of 2 components", "there are 4 points",
      "SetInputTexture()" });
  expectTextureError(
    [](TexturedQuad& scene)
    {
      vtkDataArray* const coordinates = scene.quad->GetPointData()->GetTCoords();
      coordinates->SetNumberOfComponents(4);
      coordinates->SetNumberOfTuples(4);
      coordinates->Fill(0.0);
      scene.quad->Modified();
    },
    { "Input 0", "4 tuples of 4 components", "1 to 3" });
}

TEST(BadTextures, BlocksWithoutCoordinates)
{
  expectTextureError(
    [](TexturedQuad& scene)
    {
      vtkNew<vtkMultiBlockDataSet> blocks;
      scene.quad->GetPointData()->SetTCoords(nullptr);
      blocks->SetBlock(0, scene.quad);
      scene.tracer->SetInputData(blocks);
    },
    { "Input 0: its blocks have no texture coordinates", "SetInputTexture()" });
}

TEST(BadTextures, Images)
{
  expectTextureError([](TexturedQuad& scene) { scene.texture->RemoveAllInputs(); },
    { "Input 0", "vtkTexture has no image", "SetInputConnection()" });
  expectTextureError([](TexturedQuad& scene)
    { scene.texture->SetInputData(vtkNew<vtkImageData>()); },
    { "Input 0", "no pixels", "active scalars" });
  expectTextureError(
    [](TexturedQuad& scene)
    {
      vtkNew<vtkImageData> block;
      block->SetDimensions(2, 3, 4);
      block->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
      scene.texture->SetInputData(block);
    },
    { "Input 0", "4 slices", "vtkExtractVOI" });
  expectTextureError([](TexturedQuad& scene) { scene.texture->SetInputData(makeImage(4, 3, 5)); },
    { "Input 0", "5 components", "vtkImageExtractComponents" });
  expectTextureError(
    [](TexturedQuad& scene)
    {
      const auto image = makeImage(4, 3, 3);
      image->GetPointData()->GetScalars()->SetNumberOfTuples(7);
      scene.texture->SetInputData(image);
    },
    { "Input 0", "12 pixels", "7 tuples" });
  expectTextureError([](TexturedQuad& scene) { scene.texture->CubeMapOn(); },
    { "Input 0", "cube map", "CubeMapOff()" });
}

TEST(BadTextures, Tables)
{
  expectTextureError(
    [](TexturedQuad& scene)
    {
      scene.texture->SetInputData(makeImage(4, 3, 1, VTK_FLOAT));
      scene.texture->SetLookupTable(vtkNew<vtkColorTransferFunction>());
    },
    { "Input 0", "colour transfer function", "AddRGBPoint()" });
  expectTextureError(
    [](TexturedQuad& scene)
    {
      vtkNew<vtkLookupTable> table;
      table->SetRange(1.0, HUGE_VAL);
      scene.texture->SetInputData(makeImage(4, 3, 1, VTK_FLOAT));
      scene.texture->SetLookupTable(table);
    },
    { "Input 0", "1 to inf", "finite", "SetRange()" });
  expectTextureError(
    [](TexturedQuad& scene)
    {
      vtkNew<vtkLookupTable> table;
      table->SetNumberOfTableValues(0);
      scene.texture->SetInputData(makeImage(4, 3, 1, VTK_FLOAT));
      scene.texture->SetLookupTable(table);
    },
    { "Input 0", "no colours", "SetNumberOfTableValues()" });
}

TEST(BadTextures, Transforms)
{
  for (const double element : { 2.0, std::numeric_limits<double>::quiet_NaN() })
  {
    expectTextureError(
      [element](TexturedQuad& scene)
      {
        const bool isLast = element == 2.0;
        double elements[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
        elements[isLast ? 12 : 3] = element;
        vtkNew<vtkTransform> transform;
        transform->SetMatrix(elements);
        scene.texture->SetTransform(transform);
      },
      { "Input 0", "transform", "SetTransform()", "affine" });
  }
}

TEST(BadTextures, NegativeConnection)
{
  TexturedQuad scene(4, 3);
  Messages messages(scene.tracer);
  scene.tracer->SetInputTexture(-1, nullptr);
  expectMessage(messages.errors(), { "SetInputTexture() was given connection -1" });
}

// The picture on the surface would be that of the picture.
TEST(BadTextures, ATextureOfThePictureItself)
{
  TexturedQuad scene(4, 3);
  Messages messages(scene.tracer);
  vtkNew<vtkImageFlip> flip;
  flip->SetInputConnection(scene.tracer->GetOutputPort());
  Messages ofFlip(flip);
  scene.texture->SetInputConnection(flip->GetOutputPort());
  scene.tracer->Update();
  ASSERT_EQ(messages.errors().size(), 2u);
  EXPECT_NE(
    messages.errors()[0].find("The picture is requested while it is rendered"), std::string::npos);
  EXPECT_NE(messages.errors()[1].find("Input 0: the image of its vtkTexture cannot be updated"),
    std::string::npos);
  EXPECT_EQ(scene.tracer->GetOutput()->GetNumberOfPoints(), 0);
  scene.tracer->SetInputTexture(0, nullptr);
  messages.clear();
  scene.tracer->Update();
  EXPECT_TRUE(messages.errors().empty());
  EXPECT_EQ(scene.tracer->GetOutput()->GetNumberOfPoints(), 12);
}

TEST(BadTextures, CoordinatesThatAreNotFiniteHaveAColour)
{
  TexturedQuad scene(4, 3);
  const auto image = makeImage(4, 3, 3);
  scene.texture->SetInputData(image);
  scene.quad->GetPointData()->GetTCoords()->Fill(std::numeric_limits<double>::quiet_NaN());
  const Picture picture = render(scene.tracer);
  vtkDataArray* const pixels = image->GetPointData()->GetScalars();
  const Vec first(
    pixels->GetComponent(0, 0), pixels->GetComponent(0, 1), pixels->GetComponent(0, 2));
  EXPECT_EQ(picture.count(first), 12);
}

TEST(BadTextures, InputsWithoutFacesNeedNoCoordinates)
{
  TexturedQuad scene(4, 3);
  Messages messages(scene.tracer);
  scene.tracer->SetInputData(vtkNew<vtkPolyData>());
  scene.tracer->Update();
  EXPECT_TRUE(messages.errors().empty());
  EXPECT_EQ(scene.tracer->GetOutput()->GetNumberOfPoints(), 12);
}

TEST(BadTextures, WithoutEffectAreWarnings)
{
  expectIdle([](TexturedQuad& scene) { scene.tracer->SetInputSphereRadius(0, 1.0); },
    { "Input 0", "spheres", "SetInputTexture()" });
  expectIdle([](TexturedQuad& scene)
    { scene.texture->SetBlendingMode(vtkTexture::VTK_TEXTURE_BLENDING_MODE_ADD); },
    { "Input 0", "SetBlendingMode()", "no effect", "MODE_NONE" });
  expectIdle([](TexturedQuad& scene) { scene.texture->MipmapOn(); },
    { "Input 0", "MipmapOn()", "SetSupersampling()" });
  expectIdle([](TexturedQuad& scene) { scene.property->ShowTexturesOnBackfaceOff(); },
    { "Input 0", "ShowTexturesOnBackfaceOff()" });
}
