// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Opacity of properties, blocks and colours. The situations that depth peeling and sorted cells get
// wrong: surfaces that intersect, order of inputs, many layers, opaque among transparent, a
// backface seen through a front face, and a picture with alpha.
#include "Blocks.h"
#include "ColoredGrid.h"
#include "ExpectedErrors.h"
#include "TexturedQuad.h"

#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace
{
const Vec red(1.0, 0.0, 0.0), green(0.0, 1.0, 0.0), white(1.0);

/// One pixel before a row of sheets.
struct Sheets
{
  Studio studio{ 1, 1 };
  int count = 0;

  Sheets() { this->studio.tracer->SetBackground(0.0, 0.0, 1.0); }

  /// Adds an unlit sheet at a distance from the eye.
  vtkSmartPointer<vtkProperty> add(double distance, const Vec& color, double opacity)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-9.0, -9.0, 5.0 - distance);
    plane->SetPoint1(9.0, -9.0, 5.0 - distance);
    plane->SetPoint2(-9.0, 9.0, 5.0 - distance);
    plane->Update();
    this->studio.tracer->AddInputDataObject(plane->GetOutput());
    auto property = vtkSmartPointer<vtkProperty>::New();
    property->LightingOff();
    property->SetColor(color.x, color.y, color.z);
    property->SetOpacity(opacity);
    this->studio.tracer->SetInputProperty(this->count++, property);
    return property;
  }
  Vec color() { return render(this->studio.tracer).at(0, 0); }
};
}

TEST(Transparency, DoesNotDependOnTheOrderOfInputs)
{
  Sheets front, back;
  front.add(2.0, red, 0.25);
  front.add(3.0, green, 0.5);
  back.add(3.0, green, 0.5);
  back.add(2.0, red, 0.25);
  EXPECT_EQ(front.color(), Vec(0.25, 0.375, 0.375));
  EXPECT_EQ(back.color(), front.color());
}

TEST(Transparency, OpaqueSurfacesHideWhatIsBehind)
{
  Sheets sheets;
  sheets.add(4.0, white, 0.75);
  sheets.add(3.0, green, 1.0);
  sheets.add(2.0, red, 0.25);
  EXPECT_EQ(sheets.color(), Vec(0.25, 0.75, 0.0));
}

TEST(Transparency, ManyLayersAreAllSeen)
{
  Sheets sheets;
  constexpr int count = 200;
  for (int k = 0; k < count; ++k)
  {
    sheets.add(1.0 + 0.01 * (k * 7 % count), white, 0.015625);
  }
  EXPECT_NEAR(sheets.color().x, 1.0 - std::pow(1.0 - 0.015625, count), 1e-6);
}

TEST(Transparency, SurfacesMayIntersect)
{
  Studio studio(64, 64);
  studio.camera->ParallelProjectionOn();
  studio.tracer->SetBackground(0.0, 0.0, 0.0);
  for (int k = 0; k < 2; ++k)
  {
    vtkNew<vtkPlaneSource> plane; // crosses the other one in the middle of the picture
    const double slope = k == 0 ? 1.0 : -1.0;
    plane->SetOrigin(-2.0, -2.0, -2.0 * slope);
    plane->SetPoint1(2.0, -2.0, 2.0 * slope);
    plane->SetPoint2(-2.0, 2.0, -2.0 * slope);
    plane->Update();
    studio.tracer->AddInputDataObject(plane->GetOutput());
    vtkNew<vtkProperty> property;
    property->LightingOff();
    property->SetColor(k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, 0.0);
    property->SetOpacity(0.5);
    studio.tracer->SetInputProperty(k, property);
  }
  const Picture picture = render(studio.tracer);
  for (int i = 0; i < 64; ++i)
  {
    const Vec expected = i < 32 ? Vec(0.25, 0.5, 0.0) : Vec(0.5, 0.25, 0.0);
    EXPECT_EQ(picture.at(i, 20), expected) << "column " << i;
  }
}

// An actor with opacity 0.5 and an opaque object inside, and its own back behind that.
TEST(Transparency, InsideAndBackOfAClosedSurfaceAreSeen)
{
  Studio studio(1, 1);
  studio.tracer->SetOutputAlpha(true);
  studio.property->LightingOff();
  studio.property->SetOpacity(0.5);
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  studio.tracer->SetInputData(sphere->GetOutput());
  EXPECT_EQ(render(studio.tracer).alpha(0, 0), 0.75);
  studio.property->BackfaceCullingOn();
  EXPECT_EQ(render(studio.tracer).alpha(0, 0), 0.5);
  studio.property->BackfaceCullingOff();
  studio.tracer->SetInputSphereRadius(0, 0.25); // as true spheres, all of whose points are drawn
  EXPECT_GE(render(studio.tracer).alpha(0, 0), 0.75);
}

TEST(Transparency, OfColoursMultipliesTheProperty)
{
  Sheets sheets;
  sheets.add(2.0, white, 0.5);
  auto* const mesh = vtkPolyData::SafeDownCast(sheets.studio.tracer->GetInputDataObject(0, 0));
  vtkNew<vtkUnsignedCharArray> paint;
  paint->SetName("Paint");
  paint->SetNumberOfComponents(4);
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    paint->InsertNextTuple4(255, 0, 0, 51); // alpha 0.2
  }
  mesh->GetPointData()->SetScalars(paint);
  EXPECT_EQ(sheets.color(), Vec(0.5, 0.5, 1.0)); // not visible yet
  sheets.studio.tracer->SetInputScalarVisibility(0, true);
  const Vec color = sheets.color();
  EXPECT_NEAR(color.x, 0.1, 1e-7);
  EXPECT_NEAR(color.z, 0.9, 1e-7);
}

TEST(Transparency, OfTablesIsUsed)
{
  Sheets sheets;
  sheets.add(2.0, white, 1.0);
  auto* const mesh = vtkPolyData::SafeDownCast(sheets.studio.tracer->GetInputDataObject(0, 0));
  vtkNew<vtkDoubleArray> heat;
  heat->SetName("Heat");
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    heat->InsertNextValue(0.9);
  }
  mesh->GetPointData()->SetScalars(heat);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 1.0, 1.0, 1.0, 0.0);
  table->SetTableValue(1, 1.0, 0.0, 0.0, 0.4);
  sheets.studio.tracer->SetInputScalarVisibility(0, true);
  sheets.studio.tracer->SetInputLookupTable(0, table);
  sheets.studio.tracer->SetInputScalarRange(0, 0.0, 1.0);
  for (bool isLast : { false, true })
  {
    sheets.studio.tracer->SetInputInterpolateScalarsBeforeMapping(0, isLast);
    EXPECT_NEAR(sheets.color().x, 0.4, 1e-7);
  }
  heat->FillValue(0.1);
  heat->Modified();
  EXPECT_EQ(sheets.color(), Vec(0.0, 0.0, 1.0)); // alpha 0
}

TEST(Transparency, OfTexturesMultipliesTheProperty)
{
  TexturedQuad scene(2, 1);
  const auto image = makeImage(2, 1, 4);
  auto* const pixels = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  pixels->SetTuple4(0, 255.0, 0.0, 0.0, 51.0); // alpha 0.2
  pixels->SetTuple4(1, 0.0, 255.0, 0.0, 0.0);
  scene.texture->SetInputData(image);
  scene.tracer->SetBackground(0.0, 0.0, 1.0);
  scene.property->SetOpacity(0.5);
  const Picture picture = render(scene.tracer);
  EXPECT_EQ(picture.at(0, 0), Vec(26.0, 0.0, 230.0)); // 0.1 of red
  EXPECT_EQ(picture.at(1, 0), Vec(0.0, 0.0, 255.0));
}

TEST(Transparency, OfBlocksReplacesTheProperty)
{
  Studio studio(5, 1);
  lookAtRow(studio);
  std::vector<Mesh> meshes{ makeRow(0, 1), makeRow(1, 2) };
  studio.property->LightingOff();
  studio.property->SetOpacity(0.75);
  studio.tracer->SetOutputAlpha(true);
  studio.tracer->AddInputDataObject(makeBlocks({ meshes[0], meshes[1] }));
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  attributes->SetBlockOpacity(meshes[0], 0.25);
  studio.tracer->SetInputBlockAttributes(0, attributes);
  const Picture picture = render(studio.tracer);
  EXPECT_EQ(picture.alpha(0, 0), 0.25);
  EXPECT_EQ(picture.alpha(1, 0), 0.75);
}

TEST(Transparency, IdsAreThoseOfTheNearestVisibleSurface)
{
  Sheets sheets;
  sheets.studio.tracer->GenerateIdsOn();
  sheets.add(2.0, red, 0.0);
  const auto middle = sheets.add(3.0, green, 0.125);
  sheets.add(4.0, white, 1.0);
  EXPECT_EQ(renderIds(sheets.studio, "InputIds"), Ids{ 1 });
  middle->SetOpacity(0.0);
  EXPECT_EQ(renderIds(sheets.studio, "InputIds"), Ids{ 2 });
}

TEST(Transparency, BadOpacitiesAreErrors)
{
  Studio studio(5, 1);
  lookAtRow(studio);
  const Mesh mesh = makeRow(0, 1);
  studio.tracer->AddInputDataObject(makeBlocks({ mesh }));
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  studio.tracer->SetInputBlockAttributes(0, attributes);
  Messages messages(studio.tracer);
  for (double opacity : { -0.5, 1.5, std::numeric_limits<double>::quiet_NaN() })
  {
    messages.clear();
    attributes->SetBlockOpacity(mesh, opacity);
    studio.tracer->Update();
    expectMessage(messages.errors(), { "Input 0, block 1", "opacity", "SetBlockOpacity()" });
    EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 0);
  }
  messages.clear();
  attributes->SetBlockOpacity(mesh, 1.0);
  studio.tracer->Update();
  EXPECT_TRUE(messages.errors().empty());
  EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 5);
}
