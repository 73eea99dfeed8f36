// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Visibility and colours of blocks.
#include "Blocks.h"
#include "ExpectedErrors.h"

#include <limits>

namespace
{
const Vec red(1.0, 0.0, 0.0), green(0.0, 1.0, 0.0), blue(0.0, 0.0, 1.0), grey(0.5, 0.5, 0.5);

/// A row of five pixels, each of which shows a block: 1, and 3 to 6, which are in block 2. They are
/// grey and unlit.
struct Row
{
  Studio studio{ 5, 1 };
  std::vector<Mesh> meshes;
  Blocks inner, root;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;

  Row()
  {
    lookAtRow(this->studio);
    std::vector<vtkDataObject*> children;
    for (int k = 0; k < 5; ++k)
    {
      this->meshes.push_back(makeRow(k, k + 1));
      children.push_back(this->meshes.back());
    }
    this->inner = makeBlocks({ children.begin() + 1, children.end() });
    this->root = makeBlocks({ children[0], this->inner });
    this->studio.property->LightingOff();
    this->studio.property->SetColor(grey.x, grey.y, grey.z);
    this->studio.tracer->AddInputDataObject(this->root);
    this->studio.tracer->SetInputBlockAttributes(0, this->attributes);
  }

  void paint(vtkDataObject* block, const Vec& color)
  {
    this->attributes->SetBlockColor(block, &color.x);
  }

  std::vector<Vec> colors()
  {
    const Picture picture = render(this->studio.tracer);
    std::vector<Vec> result;
    for (int k = 0; k < 5; ++k)
    {
      result.push_back(picture.at(k, 0));
    }
    return result;
  }
};
}

TEST(BlockAttributes, HideBlocks)
{
  Row row;
  row.attributes->SetBlockVisibility(row.meshes[0], false);
  row.attributes->SetBlockVisibility(row.meshes[3], false);
  EXPECT_EQ(renderIds(row.studio, "BlockIds"), (Ids{ -1, 3, 4, -1, 6 }));
  row.attributes->SetBlockVisibility(row.meshes[0], true);
  EXPECT_EQ(renderIds(row.studio, "BlockIds"), (Ids{ 1, 3, 4, -1, 6 }));
}

TEST(BlockAttributes, HideSubtrees)
{
  Row row;
  row.attributes->SetBlockVisibility(row.inner, false);
  EXPECT_EQ(renderIds(row.studio, "BlockIds"), (Ids{ 1, -1, -1, -1, -1 }));
  row.attributes->SetBlockVisibility(row.meshes[2], true); // as in vtkCompositePolyDataMapper2
  EXPECT_EQ(renderIds(row.studio, "BlockIds"), (Ids{ 1, -1, 4, -1, -1 }));
  row.attributes->RemoveBlockVisibilities();
  row.attributes->SetBlockVisibility(row.root, false);
  EXPECT_EQ(renderIds(row.studio, "BlockIds"), (Ids{ -1, -1, -1, -1, -1 }));
}

TEST(BlockAttributes, ColourBlocks)
{
  Row row;
  row.paint(row.meshes[0], red);
  row.paint(row.inner, green);
  row.paint(row.meshes[4], blue);
  EXPECT_EQ(row.colors(), (std::vector<Vec>{ red, green, green, green, blue }));
  row.attributes->RemoveBlockColor(row.inner);
  row.attributes->Modified(); // VTK 9.1 omits this
  EXPECT_EQ(row.colors(), (std::vector<Vec>{ red, grey, grey, grey, blue }));
  row.studio.tracer->SetInputBlockAttributes(0, nullptr);
  EXPECT_EQ(row.colors(), (std::vector<Vec>(5, grey)));
}

// The colour replaces both; the coefficients are the property's.
TEST(BlockAttributes, ColourDiffuseAndAmbientReflection)
{
  Studio expected, studio;
  for (Studio* s : { &expected, &studio })
  {
    s->property->SetDiffuse(0.5);
    s->property->SetAmbient(0.25);
    s->property->SetAmbientColor(0.9, 0.1, 0.2);
    s->tracer->AddLight(makeLight({ 1.0, 2.0, 3.0 }, Vec(0.0)));
  }
  const Mesh mesh = makeSphere(6);
  expected.property->SetColor(0.3, 0.6, 0.1);
  expected.tracer->AddInputDataObject(mesh);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  const double color[3] = { 0.3, 0.6, 0.1 };
  attributes->SetBlockColor(mesh, color);
  studio.tracer->AddInputDataObject(makeBlocks({ mesh }));
  studio.tracer->SetInputBlockAttributes(0, attributes);
  EXPECT_SAME_BITS(render(studio.tracer), render(expected.tracer));
}

TEST(BlockAttributes, ApplyToASingleMesh)
{
  Row row;
  row.paint(row.meshes[1], blue);
  row.studio.tracer->SetInputData(row.meshes[1]);
  EXPECT_EQ(row.colors()[1], blue);
  row.attributes->SetBlockVisibility(row.meshes[1], false);
  EXPECT_EQ(row.colors()[1], Studio::background());
}

TEST(BlockAttributes, BelongToAConnection)
{
  Row row;
  row.studio.tracer->AddInputDataObject(makeBlocks({ makeSphere(3) }));
  EXPECT_EQ(row.studio.tracer->GetInputBlockAttributes(0), row.attributes);
  EXPECT_EQ(row.studio.tracer->GetInputBlockAttributes(1), nullptr);
  row.attributes->SetBlockVisibility(row.inner, false);
  row.studio.tracer->SetInputBlockAttributes(0, nullptr);
  row.studio.tracer->SetInputBlockAttributes(1, row.attributes); // does not have these blocks
  EXPECT_EQ(row.colors()[2], grey);
  const Messages messages(row.studio.tracer);
  row.studio.tracer->SetInputBlockAttributes(-1, row.attributes);
  expectMessage(messages.errors(), { "SetInputBlockAttributes() was given connection -1" });
}

TEST(BlockAttributes, MakeThePictureOutOfDate)
{
  Row row;
  EXPECT_EQ(row.colors()[0], grey);
  vtkMTimeType before = row.studio.tracer->GetMTime();
  row.paint(row.meshes[0], red);
  EXPECT_GT(row.studio.tracer->GetMTime(), before);
  EXPECT_EQ(row.colors()[0], red);
  before = row.studio.tracer->GetMTime();
  row.studio.tracer->SetInputBlockAttributes(0, nullptr);
  EXPECT_GT(row.studio.tracer->GetMTime(), before);
}

TEST(BlockAttributes, HiddenBlocksAreNotFramed)
{
  Studio expected, studio;
  const Mesh near = makeSphere(6), far = makeMoved(makeSphere(6), Vec(50.0));
  expected.tracer->AddInputDataObject(near);
  studio.tracer->AddInputDataObject(makeBlocks({ near, far }));
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  attributes->SetBlockVisibility(far, false);
  studio.tracer->SetInputBlockAttributes(0, attributes);
  expected.tracer->ResetCamera();
  studio.tracer->ResetCamera();
  EXPECT_EQ(studio.position(), expected.position());
}

// A property that is wrong is named once, not for each block.
TEST(BlockAttributes, PropertiesAreNamedByTheirInput)
{
  Row row;
  const Messages messages(row.studio.tracer);
  vtkNew<vtkProperty> property;
  property->SetInterpolationToPBR();
  row.studio.tracer->SetInputProperty(0, property);
  render(row.studio.tracer);
  expectMessage(messages.warnings(), { "Input 0: vtkProperty::SetInterpolationToPBR()" });
}

TEST(BlockAttributes, ColoursThatAreNotFiniteAreAnError)
{
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  const Mesh mesh = makeSphere(4);
  const double wrong[3] = { 0.5, std::numeric_limits<double>::quiet_NaN(), 0.5 };
  attributes->SetBlockColor(mesh, wrong);
  expectError(
    [&](Studio& studio)
    {
      studio.tracer->AddInputDataObject(makeBlocks({ mesh }));
      studio.tracer->SetInputBlockAttributes(1, attributes);
    },
    { "Input 1, block 1: its colour", "not a finite number", "SetBlockColor()" },
    [](Studio& studio) { studio.tracer->RemoveInputConnection(0, 1); });
}
