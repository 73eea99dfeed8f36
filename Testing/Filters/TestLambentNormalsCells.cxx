// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkLambentNormals does with cells: flipping, strips, cell normals, and the cell data.

#include "TestingNormals.h"
#include "vtkLambentNormals.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

TEST(LambentNormalsCells, FlippingReversesNormalsAndPolygons)
{
  RandomMeshOptions options;
  options.cells = 300;
  vtkSmartPointer<vtkPolyData> mesh = makeRandomMesh(options);
  vtkNew<vtkLambentNormals> plain, flipped;
  plain->SetInputData(mesh);
  plain->ComputeCellNormalsOn();
  plain->Update();
  flipped->SetInputData(mesh);
  flipped->ComputeCellNormalsOn();
  flipped->FlipNormalsOn();
  flipped->Update();

  std::vector<Face> expected = facesOf(mesh);
  for (Face& face : expected)
  {
    std::reverse(face.begin(), face.end());
  }
  EXPECT_EQ(facesOf(flipped->GetOutput()), expected);
  for (int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    std::vector<float> normals =
      valuesOf(plain->GetOutput()->GetAttributes(association)->GetNormals());
    std::transform(normals.begin(), normals.end(), normals.begin(), std::negate<float>());
    EXPECT_EQ(valuesOf(flipped->GetOutput()->GetAttributes(association)->GetNormals()), normals);
  }
}

TEST(LambentNormalsCells, StripsBecomeTrianglesOnlyIfNeeded)
{
  RandomMeshOptions options;
  options.cells = 300;
  vtkSmartPointer<vtkPolyData> mesh = makeRandomMesh(options);
  mesh->GetCellData()->AddArray(makeNumbers("Number", mesh->GetNumberOfCells()));
  const std::vector<Face> faces = facesOf(mesh);
  const vtkIdType others = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();

  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(mesh);
  normals->Update();
  EXPECT_EQ(normals->GetOutput()->GetNumberOfStrips(), 300);
  EXPECT_EQ(normals->GetOutput()->GetCellData()->GetArray("Number"),
    mesh->GetCellData()->GetArray("Number"));

  normals->ComputeCellNormalsOn();
  normals->Update();
  vtkPolyData* output = normals->GetOutput();
  EXPECT_EQ(output->GetNumberOfStrips(), 0);
  EXPECT_EQ(output->GetNumberOfVerts(), mesh->GetNumberOfVerts());
  EXPECT_EQ(output->GetNumberOfLines(), mesh->GetNumberOfLines());
  EXPECT_EQ(facesOf(output), faces);
  EXPECT_EQ(mesh->GetNumberOfStrips(), 300);

  vtkDataArray* numbers = output->GetCellData()->GetArray("Number");
  vtkDataArray* cellNormals = output->GetCellData()->GetNormals();
  ASSERT_EQ(numbers->GetNumberOfTuples(), output->GetNumberOfCells());
  ASSERT_EQ(cellNormals->GetNumberOfTuples(), output->GetNumberOfCells());
  for (vtkIdType i = 0; i < others; ++i)
  {
    EXPECT_EQ(numbers->GetTuple1(i), i);
    EXPECT_EQ(tupleOf(cellNormals, i), (Vector{ 0.0, 0.0, 0.0 }));
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    expectNear(
      tupleOf(cellNormals, others + static_cast<vtkIdType>(f)), faceNormal(mesh, faces[f]), 1e-6);
  }
  std::vector<double> expected; // the strip of each triangle
  for (vtkIdType strip = 0; strip < 300; ++strip)
  {
    expected.insert(expected.end(), mesh->GetStrips()->GetCellSize(strip) - 2,
      others + mesh->GetNumberOfPolys() + strip);
  }
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_EQ(
      numbers->GetTuple1(output->GetNumberOfCells() - static_cast<vtkIdType>(expected.size() - i)),
      expected[i]);
  }
}

// The squares of these edges underflow, so their angle is undefined. Other corners are unaffected.
TEST(LambentNormalsCells, CornersBetweenVanishingEdgesAddNothing)
{
  constexpr double tiny = 1e-90;
  for (int weighting : { vtkLambentNormals::ANGLE, vtkLambentNormals::MAX })
  {
    vtkNew<vtkLambentNormals> normals;
    normals->SetInputData(makeMesh(
      { { 0, 0, 0 }, { tiny, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, tiny, 0 } },
      { { 0, 1, 2, 3, 4, 5 } }));
    normals->SetWeighting(weighting);
    normals->Update();
    vtkDataArray* found = normals->GetOutput()->GetPointData()->GetNormals();
    EXPECT_EQ(tupleOf(found, 0), (Vector{ 0, 0, 0 })) << weighting;
    for (vtkIdType point : { 2, 3, 4 })
    {
      EXPECT_EQ(tupleOf(found, point), (Vector{ 0, 0, 1 })) << weighting << ", point " << point;
    }
  }
}

TEST(LambentNormalsCells, InputIsNeverModified)
{
  vtkSmartPointer<vtkPolyData> mesh = makeCube();
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 7 });
  mesh->SetLines(lines);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 7 });
  mesh->SetStrips(strips);
  mesh->GetPointData()->AddArray(makeNumbers("Number", mesh->GetNumberOfPoints()));
  mesh->BuildLinks();
  vtkNew<vtkPolyData> before;
  before->DeepCopy(mesh);
  const vtkMTimeType time = mesh->GetMTime();
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOn();
  normals->FlipNormalsOn();
  normals->ComputeCellNormalsOn();
  normals->Update();
  EXPECT_EQ(mesh->GetMTime(), time);
  EXPECT_EQ(facesOf(mesh), facesOf(before));
  EXPECT_EQ(mesh->GetNumberOfPoints(), before->GetNumberOfPoints());
  EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(mesh->GetCellData()->GetNumberOfArrays(), 0);
  // The output has its own lookup of cells, not the input's.
  vtkPolyData* output = normals->GetOutput();
  const vtkIdType first = output->GetNumberOfVerts() + output->GetNumberOfLines();
  EXPECT_EQ(output->GetCell(first)->GetPointId(0), facesOf(output)[0][0]);
}
