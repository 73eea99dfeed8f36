// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLambentNormals with bad, degenerate and empty input.

#include "TestingNormals.h"
#include "vtkLambentNormals.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

void expectParts(const std::vector<std::string>& messages, std::vector<std::string> parts)
{
  ASSERT_EQ(messages.size(), 1u);
  for (const std::string& part : parts)
  {
    EXPECT_NE(messages[0].find(part), std::string::npos)
      << "no \"" << part << "\" in: " << messages[0];
  }
}

// After an error, the next good input works.
void expectNextGoodUpdateWorks(vtkLambentNormals* normals, const Messages& messages)
{
  const std::size_t errors = messages.errors.size();
  normals->SetInputData(makeCube());
  normals->Update();
  EXPECT_EQ(messages.errors.size(), errors);
  EXPECT_EQ(normals->GetOutput()->GetNumberOfPoints(), 8);
  ASSERT_NE(normals->GetOutput()->GetPointData()->GetNormals(), nullptr);
  expectNear(
    tupleOf(normals->GetOutput()->GetPointData()->GetNormals(), 7), unit({ 1, 1, 1 }), 1e-7);
}
}

TEST(LambentNormalsBadInput, MissingPoint)
{
  for (vtkIdType point : { vtkIdType(8), vtkIdType(-1), vtkIdType(1) << 40 })
  {
    vtkSmartPointer<vtkPolyData> cube = makeCube();
    vtkNew<vtkCellArray> lines;
    lines->InsertNextCell({ 0, 1 });
    lines->InsertNextCell({ 2, 3 });
    cube->SetLines(lines);
    cube->GetPolys()->InsertNextCell({ 0, 1, point });
    vtkNew<vtkLambentNormals> normals;
    const Messages messages(normals);
    normals->SetInputData(cube);
    normals->SplittingOn();
    normals->Update();
    // Two lines, six faces of the cube, then the bad one.
    expectParts(
      messages.errors, { "Cell 8 ", "point " + std::to_string(point), "8 points", "Correct" });
    EXPECT_EQ(normals->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(normals->GetOutput()->GetNumberOfCells(), 0);
    normals->SplittingOff();
    expectNextGoodUpdateWorks(normals, messages);
  }
}

// vtkPoints rejects an array of two components, but does not notice if its array changes later.
TEST(LambentNormalsBadInput, PointsOfTwoComponents)
{
  vtkSmartPointer<vtkPolyData> cube = makeCube();
  cube->GetPoints()->GetData()->SetNumberOfComponents(2);
  vtkNew<vtkLambentNormals> normals;
  const Messages messages(normals);
  normals->SetInputData(cube);
  normals->Update();
  expectParts(messages.errors, { "points have 2 components, not 3" });
  EXPECT_EQ(normals->GetOutput()->GetNumberOfPoints(), 0);
  expectNextGoodUpdateWorks(normals, messages);
}

TEST(LambentNormalsBadInput, MissingPointInEveryKindOfCell)
{
  using Setter = void (vtkPolyData::*)(vtkCellArray*);
  const std::pair<Setter, const char*> kinds[] = { { &vtkPolyData::SetVerts, "Cell 0 " },
    { &vtkPolyData::SetLines, "Cell 0 " }, { &vtkPolyData::SetStrips, "Cell 6 " } };
  for (const auto& [setter, name] : kinds)
  {
    vtkSmartPointer<vtkPolyData> cube = makeCube();
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({ 0, 1, 99, 2 });
    (cube->*setter)(cells);
    vtkNew<vtkLambentNormals> normals;
    const Messages messages(normals);
    normals->SetInputData(cube);
    normals->Update();
    expectParts(messages.errors, { name, "point 99" });
    EXPECT_EQ(normals->GetOutput()->GetNumberOfPoints(), 0);
  }
}

TEST(LambentNormalsBadInput, InvalidOffsets)
{
  for (vtkTypeInt64 offset : { -1, 2, 9 })
  {
    vtkNew<vtkTypeInt64Array> offsets, connectivity;
    for (vtkTypeInt64 value : { vtkTypeInt64(0), vtkTypeInt64(3), offset })
    {
      offsets->InsertNextValue(value);
    }
    for (vtkTypeInt64 value : { 0, 1, 2, 3, 4, 5 })
    {
      connectivity->InsertNextValue(value);
    }
    vtkSmartPointer<vtkPolyData> cube = makeCube();
    cube->GetPolys()->SetData(offsets, connectivity);
    vtkNew<vtkLambentNormals> normals;
    const Messages messages(normals);
    normals->SetInputData(cube);
    normals->Update();
    expectParts(messages.errors, { "Cell 1 ", "connectivity", "Rebuild" });
    EXPECT_EQ(normals->GetOutput()->GetNumberOfPoints(), 0);
    expectNextGoodUpdateWorks(normals, messages);
  }
}

TEST(LambentNormalsBadInput, NonFiniteCellsAreIgnored)
{
  for (double bad : { Infinity, -Infinity, NotANumber })
  {
    for (int component : { 0, 1, 2 })
    {
      vtkSmartPointer<vtkPolyData> cube = makeCube();
      Vector p = pointOf(cube, 7); // a corner of the faces 1, 3 and 5
      p[component] = bad;
      cube->GetPoints()->SetPoint(7, p.data());
      vtkNew<vtkCellArray> strips; // which a strip with two good triangles uses, too
      strips->InsertNextCell({ 0, 2, 1, 3, 7 });
      cube->SetStrips(strips);
      vtkNew<vtkCellArray> verts;
      verts->InsertNextCell({ 7 });
      cube->SetVerts(verts);

      vtkSmartPointer<vtkPolyData> without = makeCube();
      const std::vector<Face> faces = facesOf(without);
      without->SetPolys(makeMesh({}, { faces[0], faces[2], faces[4] })->GetPolys());

      vtkNew<vtkLambentNormals> normals;
      const Messages messages(normals);
      normals->SetInputData(cube);
      normals->ComputeCellNormalsOn();
      normals->Update();
      expectParts(messages.warnings, { "4 cells", "cell 2.", "infinite or NaN", "remove" });
      EXPECT_TRUE(messages.errors.empty());
      std::vector<float> expected = referenceNormals(without, vtkLambentNormals::ANGLE);
      EXPECT_EQ(valuesOf(normals->GetOutput()->GetPointData()->GetNormals()), expected);
      vtkDataArray* cellNormals = normals->GetOutput()->GetCellData()->GetNormals();
      for (vtkIdType cell : { 0, 2, 4, 6, 7, 8, 9 })
      {
        EXPECT_EQ(tupleOf(cellNormals, cell), (Vector{ 0.0, 0.0, 0.0 })) << cell;
      }
      EXPECT_EQ(tupleOf(cellNormals, 1), (Vector{ -1.0, 0.0, 0.0 }));
    }
  }
}

TEST(LambentNormalsBadInput, UnusedNonFinitePointsAreHarmless)
{
  vtkSmartPointer<vtkPolyData> cube = makeCube();
  cube->GetPoints()->InsertNextPoint(NotANumber, 0.0, 0.0);
  vtkNew<vtkLambentNormals> normals;
  const Messages messages(normals);
  normals->SetInputData(cube);
  normals->Update();
  EXPECT_TRUE(messages.warnings.empty());
  vtkDataArray* array = normals->GetOutput()->GetPointData()->GetNormals();
  EXPECT_EQ(tupleOf(array, 8), (Vector{ 0.0, 0.0, 0.0 }));
  expectNear(tupleOf(array, 7), unit({ 1, 1, 1 }), 1e-7);
}

TEST(LambentNormalsBadInput, MissingNormalsAreZero)
{
  // A triangle; one without area that shares an edge with it; a polygon of two points and one of
  // none; an unused point; triangles whose areas exceed the range of binary64.
  vtkSmartPointer<vtkPolyData> mesh =
    makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 2, 0, 0 }, { 9, 9, 9 }, { 1e200, 0, 0 },
               { 0, 1e200, 0 }, { 1e-200, 0, 0 }, { 0, 1e-200, 0 } },
      { { 0, 1, 2 }, { 0, 1, 3 }, { 2, 3 }, {}, { 0, 5, 6 }, { 0, 7, 8 } });
  vtkNew<vtkLambentNormals> normals;
  const Messages messages(normals);
  normals->SetInputData(mesh);
  normals->ComputeCellNormalsOn();
  for (bool splitting : { false, true })
  {
    for (int weighting = 0; weighting < 4; ++weighting)
    {
      normals->SetWeighting(weighting);
      normals->SetSplitting(splitting);
      normals->Update();
      vtkDataArray* points = normals->GetOutput()->GetPointData()->GetNormals();
      for (vtkIdType i = 0; i < 9; ++i)
      {
        EXPECT_EQ(tupleOf(points, i), (Vector{ 0.0, 0.0, i < 3 ? 1.0 : 0.0 })) << i;
      }
      vtkDataArray* cells = normals->GetOutput()->GetCellData()->GetNormals();
      for (vtkIdType i = 0; i < 6; ++i)
      {
        EXPECT_EQ(tupleOf(cells, i), (Vector{ 0.0, 0.0, i == 0 ? 1.0 : 0.0 })) << i;
      }
    }
  }
  EXPECT_TRUE(messages.errors.empty());
  EXPECT_TRUE(messages.warnings.empty());
}

TEST(LambentNormalsBadInput, BlocksOfPolygonsWithoutPoints)
{
  vtkSmartPointer<vtkPolyData> cube = makeCube();
  std::vector<Face> faces(5000);
  for (const Face& face : facesOf(cube))
  {
    faces.push_back(face);
  }
  cube->SetPolys(makeMesh({}, faces)->GetPolys());
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(cube);
  normals->Update();
  EXPECT_EQ(valuesOf(normals->GetOutput()->GetPointData()->GetNormals()),
    referenceNormals(makeCube(), vtkLambentNormals::ANGLE));
}

// The data of copied points and cells must be long enough to be copied.
TEST(LambentNormalsBadInput, DataOfTheWrongLength)
{
  vtkNew<vtkLambentNormals> normals;
  const Messages messages(normals);
  normals->SplittingOn();
  vtkSmartPointer<vtkPolyData> cube = makeCube();
  cube->GetPointData()->AddArray(makeNumbers("short", 7));
  normals->SetInputData(cube);
  normals->Update();
  expectParts(messages.errors, { "point data array \"short\" has 7 tuples", "8 points", "Remove" });
  EXPECT_EQ(normals->GetOutput()->GetNumberOfPoints(), 0);
  normals->SplittingOff(); // the data now only passes through
  normals->Update();
  EXPECT_EQ(messages.errors.size(), 1u);
  EXPECT_EQ(normals->GetOutput()->GetNumberOfPoints(), 8);

  vtkSmartPointer<vtkPolyData> strip = makeCube();
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3 });
  strip->SetStrips(strips);
  strip->GetCellData()->AddArray(makeNumbers("long", 8));
  normals->SetInputData(strip);
  normals->FlipNormalsOn();
  normals->Update();
  ASSERT_EQ(messages.errors.size(), 2u);
  expectParts(
    { messages.errors.back() }, { "cell data array \"long\" has 8 tuples", "7 cells", "Remove" });
  EXPECT_EQ(normals->GetOutput()->GetNumberOfCells(), 0);
  normals->FlipNormalsOff();
  expectNextGoodUpdateWorks(normals, messages);
}

// Strips of fewer than three points have no triangles. Where strips become triangles they
// disappear, and each remaining cell has its normal.
TEST(LambentNormalsBadInput, StripsWithoutATriangle)
{
  vtkSmartPointer<vtkPolyData> cube = makeCube();
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell(0);
  strips->InsertNextCell({ 0, 1 });
  cube->SetStrips(strips);
  vtkNew<vtkLambentNormals> normals;
  const Messages messages(normals);
  normals->SetInputData(cube);
  normals->ComputeCellNormalsOn();
  normals->Update();
  EXPECT_EQ(normals->GetOutput()->GetNumberOfCells(), 6);
  EXPECT_EQ(normals->GetOutput()->GetCellData()->GetNormals()->GetNumberOfTuples(), 6);
  EXPECT_TRUE(messages.errors.empty());
}

// Flipping negates computed normals. If there are none, there is one warning.
TEST(LambentNormalsBadInput, FlippingWithoutComputingPointNormals)
{
  const auto warningsOf = [](bool hasNormals, bool computesPoints, bool computesCells)
  {
    vtkSmartPointer<vtkPolyData> cube = makeCube();
    vtkNew<vtkLambentNormals> first, normals;
    first->SetInputData(cube);
    first->SetComputePointNormals(hasNormals);
    normals->SetInputConnection(first->GetOutputPort());
    normals->FlipNormalsOn();
    normals->SetComputePointNormals(computesPoints);
    normals->SetComputeCellNormals(computesCells);
    const Messages messages(normals);
    for (int k = 0; k < 3; ++k)
    {
      cube->Modified();
      normals->Update();
    }
    EXPECT_TRUE(messages.errors.empty());
    return messages.warnings;
  };
  expectParts(warningsOf(true, false, false),
    { "FlipNormals", "the input's normals", "ComputePointNormalsOn()", "FlipNormalsOff()" });
  expectParts(warningsOf(true, false, true), { "FlipNormals", "ComputePointNormalsOn()" });
  expectParts(warningsOf(false, false, false), { "FlipNormals", "ComputePointNormalsOn()" });
  EXPECT_TRUE(warningsOf(false, false, true).empty());
  EXPECT_TRUE(warningsOf(true, true, false).empty());
}

TEST(LambentNormalsBadInput, EmptyInputGivesEmptyOutput)
{
  for (bool everything : { false, true })
  {
    vtkNew<vtkLambentNormals> normals;
    const Messages messages(normals);
    normals->SetComputeCellNormals(everything);
    normals->SetSplitting(everything);
    normals->SetFlipNormals(everything);
    vtkNew<vtkPolyData> empty;
    normals->SetInputData(empty);
    normals->Update();
    EXPECT_EQ(normals->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(normals->GetOutput()->GetNumberOfCells(), 0);

    vtkSmartPointer<vtkPolyData> pointsOnly = makeMesh({ { 1, 2, 3 }, { 4, 5, 6 } }, {});
    normals->SetInputData(pointsOnly);
    normals->Update();
    EXPECT_EQ(
      valuesOf(normals->GetOutput()->GetPointData()->GetNormals()), std::vector<float>(6, 0.0f));
    EXPECT_TRUE(messages.errors.empty());
    EXPECT_TRUE(messages.warnings.empty());
  }
}
