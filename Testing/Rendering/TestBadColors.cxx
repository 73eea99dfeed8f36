// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Wrong settings of colours are errors that name the input, the array and the remedy. Those without
// effect are warnings.
#include "ExpectedErrors.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"

namespace
{
constexpr int ofPoints = vtkDataObject::FIELD_ASSOCIATION_POINTS;
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// Adds the point array "Heat" to the input, with so many components and, unless they are negative,
/// tuples.
void addHeat(Studio& studio, int components = 1, vtkIdType tuples = -1)
{
  auto* const mesh = vtkPolyData::SafeDownCast(studio.tracer->GetInputDataObject(0, 0));
  vtkNew<vtkFloatArray> array;
  array->SetName("Heat");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples < 0 ? mesh->GetNumberOfPoints() : tuples);
  array->Fill(0.5);
  mesh->GetPointData()->AddArray(array);
  studio.tracer->SetInputScalarVisibility(0, true);
  studio.tracer->SetInputColorArray(0, ofPoints, "Heat");
}

void reset(Studio& studio)
{
  studio.tracer->SetInputScalarVisibility(0, false);
  studio.tracer->SetInputColorArray(0, ofPoints, nullptr);
  studio.tracer->SetInputColorComponent(0, 0);
  studio.tracer->SetInputLookupTable(0, nullptr);
  studio.tracer->ResetInputScalarRange(0);
}

void expectColorError(const Change& spoil, const std::vector<std::string>& parts)
{
  expectError(spoil, parts, reset);
}

/// The warnings after a change.
std::vector<std::string> warningsAfter(const Change& change)
{
  Studio studio;
  Messages messages(studio.tracer);
  studio.tracer->SetInputData(makeSphere(6));
  change(studio);
  studio.tracer->Update();
  EXPECT_TRUE(messages.errors().empty());
  return messages.warnings();
}
}

TEST(BadColors, Arrays)
{
  expectColorError(
    [](Studio& studio)
    {
      studio.tracer->SetInputScalarVisibility(0, true);
      studio.tracer->SetInputColorArray(0, ofPoints, "Heat");
    },
    { "Input 0", "SetInputColorArray()", "point array \"Heat\"", "another name" });
  expectColorError([](Studio& studio) { addHeat(studio, 1, 7); },
    { "Input 0", "point array \"Heat\"", "7 tuples of 1 components", "points",
      "Correct the array" });
  expectColorError(
    [](Studio& studio)
    {
      addHeat(studio);
      studio.tracer->SetInputColorArray(0, 7, "Heat");
    },
    { "Input 0", "the association 7", "FIELD_ASSOCIATION_POINTS" });
  for (const int component : { -2, 3 })
  {
    expectColorError(
      [component](Studio& studio)
      {
        addHeat(studio, 3);
        studio.tracer->SetInputColorComponent(0, component);
      },
      { "Input 0", "SetInputColorComponent()", std::to_string(component), "\"Heat\"", "0 to 2" });
  }
}

TEST(BadColors, Ranges)
{
  const double ranges[][2] = { { 1.0, 0.0 }, { notANumber, 1.0 }, { 0.0, HUGE_VAL } };
  for (const auto& range : ranges)
  {
    expectColorError(
      [&range](Studio& studio)
      {
        addHeat(studio);
        studio.tracer->SetInputScalarRange(0, range[0], range[1]);
      },
      { "Input 0", "SetInputScalarRange()", "finite" });
  }
  expectColorError(
    [](Studio& studio)
    {
      addHeat(studio);
      vtkNew<vtkLookupTable> table;
      table->SetRange(1.0, 10.0);
      table->SetScaleToLog10();
      studio.tracer->SetInputLookupTable(0, table);
      studio.tracer->SetInputScalarRange(0, 0.0, 10.0);
    },
    { "Input 0", "logarithmic", "0 to 10", "SetInputScalarRange()" });
}

TEST(BadColors, Tables)
{
  expectColorError(
    [](Studio& studio)
    {
      addHeat(studio);
      studio.tracer->SetInputLookupTable(0, vtkNew<vtkColorTransferFunction>());
    },
    { "Input 0", "no colours", "AddRGBPoint()" });
}

TEST(BadColors, NegativeConnections)
{
  Studio studio;
  Messages messages(studio.tracer);
  const vtkMTimeType before = studio.tracer->GetMTime();
  studio.tracer->SetInputScalarVisibility(-1, true);
  studio.tracer->SetInputColorArray(-1, ofPoints, "Heat");
  studio.tracer->SetInputColorComponent(-1, 0);
  studio.tracer->SetInputLookupTable(-1, nullptr);
  studio.tracer->SetInputScalarRange(-1, 0.0, 1.0);
  studio.tracer->ResetInputScalarRange(-1);
  studio.tracer->SetInputInterpolateScalarsBeforeMapping(-1, true);
  ASSERT_EQ(messages.errors().size(), 7u);
  EXPECT_NE(messages.errors()[0].find("SetInputScalarVisibility() was given connection -1"),
    std::string::npos);
  EXPECT_EQ(studio.tracer->GetMTime(), before);
}

TEST(BadColors, WithoutEffectAreWarnings)
{
  const auto unused = warningsAfter(
    [](Studio& studio)
    {
      addHeat(studio);
      studio.tracer->SetInputScalarVisibility(0, false);
    });
  expectMessage(unused, { "Input 0", "no effect", "SetInputScalarVisibility()" });
  const auto without =
    warningsAfter([](Studio& studio) { studio.tracer->SetInputScalarVisibility(0, true); });
  expectMessage(without, { "Input 0", "no active scalars", "SetInputColorArray()" });
}

TEST(BadColors, BlocksWithoutTheArray)
{
  Studio studio;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, makeSphere(6));
  studio.tracer->SetInputData(blocks);
  studio.tracer->SetInputScalarVisibility(0, true);
  studio.tracer->SetInputColorArray(0, ofPoints, "Heat");
  Messages messages(studio.tracer);
  studio.tracer->Update();
  expectMessage(messages.errors(),
    { "Input 0", "point array \"Heat\"", "none of its blocks", "SetInputColorArray()" });
  EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(BadColors, SpheresWithColoursOfCells)
{
  expectError(
    [](Studio& studio)
    {
      auto* const mesh = vtkPolyData::SafeDownCast(studio.tracer->GetInputDataObject(0, 0));
      vtkNew<vtkFloatArray> array;
      array->SetName("Part");
      array->SetNumberOfTuples(mesh->GetNumberOfCells());
      array->Fill(0.5);
      mesh->GetCellData()->AddArray(array);
      studio.tracer->SetInputScalarVisibility(0, true);
      studio.tracer->SetInputColorArray(0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Part");
      studio.tracer->SetInputSphereRadius(0, 0.1);
    },
    { "Input 0", "cell array", "spheres", "SetInputColorArray()" },
    [](Studio& studio)
    {
      reset(studio);
      studio.tracer->SetInputSphereRadius(0, 0.0);
    });
}
