// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Pass arrays of all types and memory layouts.
#include "Messages.h"
#include "PassRays.h"

#include "vtkDataObject.h"
#include "vtkSOADataArrayTemplate.h"

namespace
{
constexpr int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
constexpr int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
}

// Arrays become float if float can hold their numbers exactly, otherwise double.
TEST(PassArrayTypes, OutputTypesCanHoldTheNumbers)
{
  const std::pair<int, int> types[] = { { VTK_CHAR, VTK_FLOAT }, { VTK_SIGNED_CHAR, VTK_FLOAT },
    { VTK_UNSIGNED_CHAR, VTK_FLOAT }, { VTK_SHORT, VTK_FLOAT }, { VTK_UNSIGNED_SHORT, VTK_FLOAT },
    { VTK_INT, VTK_DOUBLE }, { VTK_UNSIGNED_INT, VTK_DOUBLE }, { VTK_LONG_LONG, VTK_DOUBLE },
    { VTK_UNSIGNED_LONG_LONG, VTK_DOUBLE }, { VTK_ID_TYPE, VTK_DOUBLE }, { VTK_FLOAT, VTK_FLOAT },
    { VTK_DOUBLE, VTK_DOUBLE }, { VTK_BIT, VTK_FLOAT },
    { VTK_LONG, sizeof(long) == 8 || sizeof(long) == 4 ? VTK_DOUBLE : VTK_FLOAT } };
  for (const auto& [type, expected] : types)
  {
    for (const int association : { points, cells })
    {
      Studio studio(4, 2);
      lookAtUnitSquares(studio);
      const Mesh grid = makeGrid(4, 0.0, 0.0);
      const auto array = addArray(grid, association, type, "Numbers", 2);
      // The values ascend evenly in x, so they are interpolated without rounding.
      for (vtkIdType k = 0; k < array->GetNumberOfTuples(); ++k)
      {
        array->SetComponent(k, 0,
          type == VTK_BIT           ? 1.0
            : association == points ? 4.0 * (k % 5)
                                    : k);
        array->SetComponent(k, 1, 1.0);
      }
      studio.tracer->SetInputData(grid);
      studio.tracer->AddPassArray(association, "Numbers");
      studio.tracer->GenerateIdsOn();
      studio.tracer->Update();
      vtkDataArray* const pass = passOf(studio.tracer->GetOutput(), "Numbers");
      EXPECT_EQ(pass->GetDataType(), expected) << array->GetDataTypeAsString();
      ASSERT_EQ(pass->GetNumberOfComponents(), 2);
      for (vtkIdType pixel = 0; pixel < 8; ++pixel)
      {
        const double first = type == VTK_BIT ? 1.0
          : association == points            ? 4.0 * (pixel % 4 + 0.5)
                                             : valueAt(studio, "CellIds", pixel);
        EXPECT_EQ(pass->GetComponent(pixel, 0), first) << array->GetDataTypeAsString();
        EXPECT_EQ(pass->GetComponent(pixel, 1), 1.0) << array->GetDataTypeAsString();
      }
    }
  }
}

TEST(PassArrayTypes, LargeIntegersAndDoublesAreExact)
{
  Studio studio(2, 2);
  const Mesh square = makeSquare();
  addArray(square, cells, VTK_INT, "Int", 1)->SetComponent(0, 0, 2147483647.0);
  addArray(square, cells, VTK_LONG_LONG, "Wide", 1)->SetComponent(0, 0, 9007199254740992.0);
  addArray(square, cells, VTK_DOUBLE, "Real", 1)->SetComponent(0, 0, 0.1);
  studio.tracer->SetInputData(square);
  for (const char* name : { "Int", "Wide", "Real" })
  {
    studio.tracer->AddPassArray(cells, name);
  }
  studio.tracer->Update();
  EXPECT_EQ(valueAt(studio, "Int", 3), 2147483647.0);
  EXPECT_EQ(valueAt(studio, "Wide", 3), 9007199254740992.0);
  EXPECT_EQ(valueAt(studio, "Real", 3), 0.1);
}

namespace
{
/// Expects that an array with another memory layout gives the same pass.
template <typename Value>
void expectOfLayout(int type, int expectedType)
{
  const Mesh grid = makeGrid(4, 0.0, 0.0);
  const auto plain = addArray(grid, points, type, "Plain", 3);
  vtkNew<vtkSOADataArrayTemplate<Value>> apart;
  apart->SetName("Apart");
  apart->SetNumberOfComponents(3);
  apart->SetNumberOfTuples(plain->GetNumberOfTuples());
  for (vtkIdType k = 0; k < plain->GetNumberOfTuples(); ++k)
  {
    apart->SetTuple(k, plain->GetTuple(k));
  }
  grid->GetPointData()->AddArray(apart);
  Studio studio(9, 8);
  studio.look({ 2.0, 2.0, 5.0 }, { 2.0, 2.0, 0.0 });
  studio.tracer->SetInputData(grid);
  studio.tracer->AddPassArray(points, "Plain");
  studio.tracer->AddPassArray(points, "Apart");
  studio.tracer->Update();
  vtkDataArray* const expected = passOf(studio.tracer->GetOutput(), "Plain");
  vtkDataArray* const found = passOf(studio.tracer->GetOutput(), "Apart");
  EXPECT_EQ(found->GetDataType(), expectedType);
  EXPECT_FALSE(isNothing(expected, 40));
  for (vtkIdType pixel = 0; pixel < 72; ++pixel)
  {
    EXPECT_EQ(tupleBits(found, pixel), tupleBits(expected, pixel));
  }
}
}

TEST(PassArrayTypes, MemoryLayoutsDoNotMatter)
{
  expectOfLayout<float>(VTK_FLOAT, VTK_FLOAT);
  expectOfLayout<double>(VTK_DOUBLE, VTK_DOUBLE);
  expectOfLayout<int>(VTK_INT, VTK_DOUBLE);
  expectOfLayout<unsigned char>(VTK_UNSIGNED_CHAR, VTK_FLOAT);
}

// One input has bytes and the other doubles. The picture's array can hold both.
TEST(PassArrayTypes, SeveralInputsGetTheWidestType)
{
  Studio studio(2, 1);
  lookAtUnitSquares(studio);
  const Mesh left = makeGrid(1, 0.0, 0.0), right = makeGrid(1, 1.0, 0.0);
  const auto bytes = addArray(left, cells, VTK_UNSIGNED_CHAR, "Mixed", 1);
  const auto doubles = addArray(right, cells, VTK_DOUBLE, "Mixed", 1);
  bytes->Fill(200.0);
  doubles->Fill(0.1);
  studio.tracer->AddInputDataObject(left);
  studio.tracer->AddInputDataObject(right);
  studio.tracer->AddPassArray(cells, "Mixed");
  studio.tracer->Update();
  EXPECT_EQ(passOf(studio.tracer->GetOutput(), "Mixed")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(valueAt(studio, "Mixed", 0), 200.0);
  EXPECT_EQ(valueAt(studio, "Mixed", 1), 0.1);
}

// An empty input may still have the array, which then determines the output's type.
TEST(PassArrayTypes, EmptyInputsKeepTypeAndComponents)
{
  Studio studio(3, 2);
  const Messages messages(studio.tracer);
  const Mesh nothing = Mesh::New();
  addArray(nothing, points, VTK_DOUBLE, "Flow", 3);
  studio.tracer->SetInputData(nothing);
  studio.tracer->AddPassArray(points, "Flow");
  studio.tracer->Update();
  vtkDataArray* const pass = passOf(studio.tracer->GetOutput(), "Flow");
  EXPECT_EQ(pass->GetNumberOfComponents(), 3);
  EXPECT_EQ(pass->GetDataType(), VTK_DOUBLE);
  for (vtkIdType pixel = 0; pixel < 6; ++pixel)
  {
    EXPECT_TRUE(isNothing(pass, pixel));
  }
  EXPECT_TRUE(messages.errors().empty());
  EXPECT_TRUE(messages.warnings().empty());
}
