// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Pictures of surfaces with textures: the image's own bytes, vtkTexture's settings, and the lit
// colour times the texture's. TestTextureMapping.cxx tests which pixels are colours.
#include "Meshes.h"
#include "Messages.h"
#include "TexturedQuad.h"

#include "vtkCellData.h"
#include "vtkImageFlip.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

namespace
{
constexpr int width = 17, height = 9;

const auto same = [](int i, int j) { return std::pair(i, j); };
}

TEST(Textures, ImagesAreSeenUnchanged)
{
  for (int components = 1; components <= 4; ++components)
  {
    for (const bool isInterpolated : { false, true })
    {
      TexturedQuad scene(width, height);
      const auto image = makeImage(width, height, components);
      scene.texture->SetInputData(image);
      scene.texture->SetInterpolate(isInterpolated);
      expectImage(scene, image, same);
    }
  }
}

TEST(Textures, WrapsTheImage)
{
  // Twice the image in each direction, after half of it.
  TexturedQuad scene(3 * width, 3 * height, -1.0, -1.0, 2.0, 2.0);
  const auto image = makeImage(width, height, 3);
  scene.texture->SetInputData(image);
  expectImage(scene, image, [](int i, int j) { return std::pair(i % width, j % height); });
  scene.texture->SetWrap(vtkTexture::ClampToEdge);
  const auto clamp = [](int k, int n) { return std::min(std::max(k - n, 0), n - 1); };
  expectImage(
    scene, image, [&](int i, int j) { return std::pair(clamp(i, width), clamp(j, height)); });
  scene.texture->SetWrap(vtkTexture::MirroredRepeat);
  const auto mirror = [](int k, int n) { return k / n == 1 ? k % n : n - 1 - k % n; };
  expectImage(
    scene, image, [&](int i, int j) { return std::pair(mirror(i, width), mirror(j, height)); });
  scene.texture->SetWrap(vtkTexture::ClampToBorder);
  scene.texture->SetBorderColor(0.2f, 0.4f, 0.6f, 1.0f);
  const Picture picture = render(scene.tracer);
  EXPECT_EQ(picture.at(0, 0), Vec(51.0, 102.0, 153.0));
  EXPECT_EQ(picture.at(width, height), colorOf(image, 0, 0));
}

TEST(Textures, Transform)
{
  TexturedQuad scene(width, height);
  const auto image = makeImage(width, height, 3);
  scene.texture->SetInputData(image);
  vtkNew<vtkTransform> transform;
  transform->Scale(-1.0, 1.0, 1.0);
  scene.texture->SetTransform(transform);
  expectImage(scene, image, [](int i, int j) { return std::pair(width - 1 - i, j); });
  transform->Identity();
  transform->Translate(3.0 / width, 0.0, 5.0);
  expectImage(scene, image, [](int i, int j) { return std::pair((i + 3) % width, j); });
  transform->Identity();
  transform->RotateZ(90.0); // (u, v) becomes (-v, u)
  expectImage(scene, image,
    [](int i, int j)
    {
      const double s = -(j + 0.5) / height, t = (i + 0.5) / width;
      return std::pair(static_cast<int>((s + 1.0) * width), static_cast<int>(t * height));
    });
}

TEST(Textures, SRGB)
{
  TexturedQuad scene(width, height);
  const auto image = makeImage(width, height, 3);
  scene.tracer->SetOutputScalarTypeToFloat();
  scene.texture->SetInputData(image);
  scene.texture->UseSRGBColorSpaceOn();
  const Picture picture = render(scene.tracer);
  for (int i = 0; i < width; ++i)
  {
    const Vec byte = colorOf(image, i, 3) / 255.0;
    const auto linear = [](double x)
    { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
    expectColor(
      picture.at(i, 3), Vec(linear(byte.x), linear(byte.y), linear(byte.z)), pixelName(i, 3), 1e-7);
  }
}

TEST(Textures, ImagesInOtherPlanesAndOfCells)
{
  const auto image = makeImage(width, height, 3);
  vtkNew<vtkImageData> upright, ofCells;
  upright->SetDimensions(1, width, height);
  upright->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  ofCells->SetDimensions(width + 1, height + 1, 1);
  ofCells->GetCellData()->SetScalars(image->GetPointData()->GetScalars());
  for (vtkImageData* const form : { upright.Get(), ofCells.Get() })
  {
    TexturedQuad scene(width, height);
    scene.texture->SetInputData(form);
    expectImage(scene, image, same);
  }
}

// The texture multiplies the lit colour, which may come from an array.
TEST(Textures, MultiplyTheLitColour)
{
  for (const bool isColored : { false, true })
  {
    Studio studio(64, 48);
    auto mesh = makeSphere(12);
    vtkNew<vtkFloatArray> coordinates;
    vtkNew<vtkUnsignedCharArray> colors;
    coordinates->SetNumberOfComponents(2);
    colors->SetNumberOfComponents(3);
    colors->SetName("Paint");
    for (const Vec& p : pointsOf(mesh))
    {
      coordinates->InsertNextTuple2(p.x, p.y);
      colors->InsertNextTuple3(100.0 + 50.0 * p.x, 100.0 + 50.0 * p.y, 200.0);
    }
    mesh->GetPointData()->SetTCoords(coordinates);
    mesh->GetPointData()->SetScalars(colors);
    studio.tracer->SetInputData(mesh);
    studio.tracer->SetInputScalarVisibility(0, isColored);
    studio.reflect(Vec(0.5, 0.6, 0.7), Vec(0.1, 0.2, 0.3));
    studio.property->SetAmbient(1.0);
    const Picture plain = render(studio.tracer);
    vtkNew<vtkTexture> texture;
    texture->SetInputData(makeImage(7, 5, 3));
    texture->InterpolateOn();
    studio.tracer->SetInputTexture(0, texture);
    const Picture textured = render(studio.tracer);
    studio.property->LightingOff();
    studio.property->SetDiffuseColor(1.0, 1.0, 1.0);
    studio.tracer->SetInputScalarVisibility(0, false);
    const Picture factor = render(studio.tracer);
    int surface = 0;
    for (int j = 0; j < plain.height(); ++j)
    {
      for (int i = 0; i < plain.width(); ++i)
      {
        const bool isHit = plain.at(i, j) != Studio::background();
        surface += isHit ? 1 : 0;
        expectColor(textured.at(i, j), isHit ? plain.at(i, j) * factor.at(i, j) : plain.at(i, j),
          pixelName(i, j));
      }
    }
    EXPECT_GT(surface, 500);
  }
}

TEST(Textures, OneOrThreeCoordinates)
{
  const auto image = makeImage(width, height, 3);
  for (const int components : { 1, 3 })
  {
    TexturedQuad scene(width, height);
    vtkDataArray* const two = scene.quad->GetPointData()->GetTCoords();
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetNumberOfComponents(components);
    coordinates->SetNumberOfTuples(4);
    coordinates->Fill(7.0);
    for (int c = 0; c < std::min(components, 2); ++c)
    {
      coordinates->CopyComponent(c, two, c);
    }
    scene.quad->GetPointData()->SetTCoords(coordinates);
    scene.texture->SetInputData(image);
    expectImage(scene, image, [&](int i, int j) { return std::pair(i, components == 1 ? 0 : j); });
  }
}

// The filters that produce the image are not inputs of the ray tracer.
TEST(Textures, FollowTheirPipeline)
{
  TexturedQuad scene(width, height);
  auto image = makeImage(width, height, 3);
  vtkNew<vtkImageFlip> flip;
  flip->SetInputData(image);
  flip->SetFilteredAxis(0);
  scene.texture->SetInputConnection(flip->GetOutputPort());
  const auto flipped = [](int i, int j) { return std::pair(width - 1 - i, j); };
  expectImage(scene, image, flipped);
  int executions = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&executions);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* all, void*) { ++*static_cast<int*>(all); });
  scene.tracer->AddObserver(vtkCommand::StartEvent, count);
  expectImage(scene, image, flipped);
  EXPECT_EQ(executions, 0);
  image->GetPointData()->GetScalars()->Fill(99.0);
  image->GetPointData()->GetScalars()->Modified();
  image->Modified();
  expectImage(scene, image, flipped);
  EXPECT_EQ(executions, 1);
  image = makeImage(width, height, 4);
  flip->SetInputData(image);
  expectImage(scene, image, flipped);
  flip->SetFilteredAxis(1);
  expectImage(scene, image, [](int i, int j) { return std::pair(i, height - 1 - j); });
  vtkNew<vtkTransform> transform;
  scene.texture->SetTransform(transform);
  scene.tracer->Update();
  const int before = executions;
  transform->Translate(0.5, 0.0, 0.0);
  scene.tracer->Update();
  EXPECT_EQ(executions, before + 1);
}

TEST(Textures, OfBlocks)
{
  TexturedQuad scene(width, height);
  const auto image = makeImage(width, height, 3);
  scene.texture->SetInputData(image);
  const auto plain = makeQuad(width, height);
  plain->GetPointData()->SetTCoords(nullptr);
  for (vtkIdType p = 0; p < 4; ++p)
  {
    const double* const point = plain->GetPoint(p);
    plain->GetPoints()->SetPoint(p, 0.5 * point[0], point[1], 0.5); // in front of the left half
  }
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, plain);
  blocks->SetBlock(1, scene.quad);
  scene.tracer->SetInputData(blocks);
  const Picture picture = render(scene.tracer);
  EXPECT_EQ(picture.at(0, 0), Vec(255.0));
  EXPECT_EQ(picture.at(width - 1, 0), colorOf(image, width - 1, 0));
}

TEST(Textures, StayWithTheirConnections)
{
  vtkNew<vtkLambentRayTracer> tracer;
  vtkNew<vtkTexture> texture;
  tracer->AddInputDataObject(makeQuad(1, 1));
  tracer->AddInputDataObject(makeQuad(2, 2));
  tracer->SetInputTexture(1, texture);
  EXPECT_EQ(tracer->GetInputTexture(0), nullptr);
  EXPECT_EQ(tracer->GetInputTexture(1), texture);
  std::ostringstream text;
  tracer->Print(text);
  EXPECT_NE(text.str().find("InputTexture 1:"), std::string::npos);
  tracer->RemoveInputConnection(0, 0);
  EXPECT_EQ(tracer->GetInputTexture(0), texture);
  const vtkMTimeType before = tracer->GetMTime();
  texture->InterpolateOn();
  EXPECT_GT(tracer->GetMTime(), before);
  tracer->SetInputTexture(0, nullptr);
  EXPECT_EQ(tracer->GetInputTexture(0), nullptr);
}
