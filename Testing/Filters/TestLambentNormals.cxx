// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compares vtkLambentNormals with closed forms and, where the two must agree, with
// vtkPolyDataNormals, and tests it as a pipeline stage.

#include "TestingNormals.h"
#include "vtkLambentNormals.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkSphereSource.h>
#include <vtkTriangleFilter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace
{
constexpr int AllWeightings[] = { vtkLambentNormals::UNIFORM, vtkLambentNormals::AREA,
  vtkLambentNormals::ANGLE, vtkLambentNormals::MAX };

// The corner of a box at the origin, seen from inside. Two triangles of the wall x = 0 meet at the
// corner; the walls y = 0 and z = 0 have one triangle each, with an edge of length 3.
vtkSmartPointer<vtkPolyData> makeCorner()
{
  return makeMesh({ { 0, 0, 0 }, { 3, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0, 1, 1 } },
    { { 0, 2, 4 }, { 0, 4, 3 }, { 0, 3, 1 }, { 0, 1, 2 } });
}

Vector normalAt(vtkPolyData* mesh, vtkIdType point)
{
  return tupleOf(mesh->GetPointData()->GetNormals(), point);
}
}

TEST(LambentNormals, CornerOfABoxByHand)
{
  // Uniform: two faces towards x, one each towards y and z. Area: twice the areas are
  // 1 + 1, 3 and 3. Angle: 45 + 45, 90 and 90 degrees. Max: 1/2 + 1/2, 3/9 and 3/9.
  const Vector expected[] = { { 2, 1, 1 }, { 2, 3, 3 }, { 1, 1, 1 }, { 3, 1, 1 } };
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(makeCorner());
  for (int weighting : AllWeightings)
  {
    SCOPED_TRACE(weighting);
    normals->SetWeighting(weighting);
    normals->Update();
    expectNear(normalAt(normals->GetOutput(), 0), unit(expected[weighting]), 1e-7);
  }
}

TEST(LambentNormals, AngleWeightsDoNotDependOnTheTriangulation)
{
  // One face of the cube as a quad, then divided along each diagonal.
  vtkNew<vtkLambentNormals> normals;
  const std::vector<std::vector<Face>> cuts = { { { 0, 4, 6, 2 } }, { { 0, 4, 6 }, { 0, 6, 2 } },
    { { 0, 4, 2 }, { 4, 6, 2 } } };
  for (const std::vector<Face>& cut : cuts)
  {
    vtkSmartPointer<vtkPolyData> cube = makeCube();
    std::vector<Face> faces = facesOf(cube);
    faces.erase(faces.begin());
    faces.insert(faces.end(), cut.begin(), cut.end());
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(cube->GetPoints());
    mesh->SetPolys(makeMesh({}, faces)->GetPolys());
    normals->SetInputData(mesh);
    normals->Update();
    for (vtkIdType i = 0; i < 8; ++i)
    {
      const Vector fromCentre = pointOf(mesh, i) - Vector{ 0.5, 0.5, 0.5 };
      expectNear(normalAt(normals->GetOutput(), i), unit(fromCentre), 1e-7);
    }
  }
}

TEST(LambentNormals, ConcavePolygonIsFlatInAllWeightings)
{
  // An L of six points, and the square that fills its reflex corner.
  vtkSmartPointer<vtkPolyData> mesh = makeMesh(
    { { 0, 0, 5 }, { 2, 0, 5 }, { 2, 1, 5 }, { 1, 1, 5 }, { 1, 2, 5 }, { 0, 2, 5 }, { 2, 2, 5 } },
    { { 0, 1, 2, 3, 4, 5 }, { 3, 2, 6, 4 } });
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(mesh);
  for (int weighting : AllWeightings)
  {
    normals->SetWeighting(weighting);
    normals->Update();
    for (vtkIdType i = 0; i < 7; ++i)
    {
      expectNear(normalAt(normals->GetOutput(), i), { 0, 0, 1 }, 0.0);
    }
  }
}

TEST(LambentNormals, ReflexCornerUsesItsInnerAngle)
{
  // The L lies in z = 0. A wall that faces -y stands on its edge from the reflex corner. At that
  // corner the L's angle is 270 degrees, the wall's 90.
  vtkSmartPointer<vtkPolyData> mesh =
    makeMesh({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 },
               { 2, 1, 1 }, { 1, 1, 1 } },
      { { 0, 1, 2, 3, 4, 5 }, { 3, 2, 6, 7 } });
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(mesh);
  normals->Update();
  expectNear(normalAt(normals->GetOutput(), 3), unit({ 0, -1, 3 }), 1e-7);
}

TEST(LambentNormals, SphereNormalsPointAwayFromTheCentre)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(23);
  sphere->SetPhiResolution(17);
  sphere->SetCenter(3.0, -2.0, 1.0);
  sphere->Update();
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputConnection(sphere->GetOutputPort());
  for (int weighting : AllWeightings)
  {
    normals->SetWeighting(weighting);
    normals->Update();
    vtkPolyData* output = normals->GetOutput();
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const Vector radial = unit(pointOf(output, i) - Vector{ 3.0, -2.0, 1.0 });
      const Vector normal = normalAt(output, i);
      EXPECT_NEAR(dot(normal, normal), 1.0, 1e-6);
      EXPECT_GT(dot(normal, radial), 0.995);
      if (weighting == vtkLambentNormals::MAX)
      {
        // Max's weights are exact where all points lie on a sphere.
        expectNear(normal, radial, 2e-5);
      }
    }
  }
}

TEST(LambentNormals, NoPrecisionIsLostFarFromTheOrigin)
{
  // Edges of 2^-10 at coordinates of 2^23, which are exact in double. The bits must be the same as
  // near the origin, also for a polygon.
  const Vector far{ 8388608.0, -8388608.0, 4194304.0 };
  const double size = 1.0 / 1024.0;
  std::vector<Vector> here, there;
  const double shape[][3] = { { 0, 0, 0 }, { 3, 1, 0 }, { 4, 4, 1 }, { 1, 5, 2 }, { -1, 2, 1 },
    { 2, 2, 7 } };
  for (const auto& p : shape)
  {
    here.push_back({ p[0] * size, p[1] * size, p[2] * size });
    there.push_back({ far[0] + p[0] * size, far[1] + p[1] * size, far[2] + p[2] * size });
  }
  const std::vector<Face> faces = { { 0, 1, 2, 3, 4 }, { 0, 5, 1 }, { 1, 5, 2 } };
  vtkNew<vtkLambentNormals> a, b;
  a->SetInputData(makeMesh(here, faces));
  b->SetInputData(makeMesh(there, faces));
  a->Update();
  b->Update();
  EXPECT_EQ(valuesOf(a->GetOutput()->GetPointData()->GetNormals()),
    valuesOf(b->GetOutput()->GetPointData()->GetNormals()));
}

TEST(LambentNormals, AgreeWithVTKWhereFacetsAreCongruent)
{
  for (int solid = 0; solid < 5; ++solid)
  {
    SCOPED_TRACE(solid);
    vtkNew<vtkPlatonicSolidSource> source;
    source->SetSolidType(solid);
    vtkNew<vtkPolyDataNormals> reference;
    reference->SetInputConnection(source->GetOutputPort());
    reference->SplittingOff();
    reference->ConsistencyOff();
    reference->ComputeCellNormalsOn();
    reference->Update();
    vtkNew<vtkLambentNormals> normals;
    normals->SetInputConnection(source->GetOutputPort());
    normals->ComputeCellNormalsOn();
    for (int weighting : AllWeightings)
    {
      normals->SetWeighting(weighting);
      normals->Update();
      for (int association : { vtkDataObject::POINT, vtkDataObject::CELL })
      {
        vtkDataArray* ours = normals->GetOutput()->GetAttributes(association)->GetNormals();
        vtkDataArray* theirs = reference->GetOutput()->GetAttributes(association)->GetNormals();
        ASSERT_EQ(ours->GetNumberOfTuples(), theirs->GetNumberOfTuples());
        for (vtkIdType i = 0; i < ours->GetNumberOfTuples(); ++i)
        {
          expectNear(tupleOf(ours, i), tupleOf(theirs, i), 1e-5);
        }
      }
    }
  }
}

TEST(LambentNormals, ArraysAreFloatNamedAndActive)
{
  vtkSmartPointer<vtkPolyData> cube = makeCube();
  vtkNew<vtkFloatArray> old;
  old->SetName("Old");
  old->SetNumberOfComponents(3);
  old->SetNumberOfTuples(8);
  old->Fill(0.0);
  cube->GetPointData()->SetNormals(old);
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(cube);
  normals->ComputeCellNormalsOn();
  normals->Update();
  vtkPolyData* output = normals->GetOutput();
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(output->GetPointData()),
         static_cast<vtkDataSetAttributes*>(output->GetCellData()) })
  {
    ASSERT_NE(data->GetNormals(), nullptr);
    EXPECT_STREQ(data->GetNormals()->GetName(), "Normals");
    EXPECT_EQ(data->GetNormals()->GetDataType(), VTK_FLOAT);
    EXPECT_EQ(data->GetNormals()->GetNumberOfComponents(), 3);
  }
  EXPECT_EQ(output->GetPointData()->GetArray("Old"), old) << "other arrays pass through";
  EXPECT_EQ(output->GetPoints(), cube->GetPoints()) << "what is not changed is shared";
  EXPECT_EQ(cube->GetPointData()->GetNormals(), old) << "the input is not modified";
  EXPECT_EQ(cube->GetCellData()->GetNormals(), nullptr);

  normals->ComputePointNormalsOff();
  normals->ComputeCellNormalsOff();
  normals->Update();
  EXPECT_EQ(normals->GetOutput()->GetPointData()->GetNormals(), old);
  EXPECT_EQ(normals->GetOutput()->GetCellData()->GetNormals(), nullptr);
}

TEST(LambentNormals, AnyKindOfPointArray)
{
  vtkSmartPointer<vtkPolyData> cube = makeCube();
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(cube);
  normals->Update();
  const std::vector<float> expected = valuesOf(normals->GetOutput()->GetPointData()->GetNormals());
  vtkNew<vtkSOADataArrayTemplate<double>> separate;
  for (vtkSmartPointer<vtkDataArray> array : { vtkSmartPointer<vtkDataArray>(separate),
         vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(VTK_SHORT)) })
  {
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(8);
    array->InsertTuples(0, 8, 0, cube->GetPoints()->GetData());
    vtkNew<vtkPolyData> mesh;
    vtkNew<vtkPoints> points;
    points->SetData(array);
    mesh->SetPoints(points);
    mesh->SetPolys(cube->GetPolys());
    normals->SetInputData(mesh);
    normals->Update();
    EXPECT_EQ(valuesOf(normals->GetOutput()->GetPointData()->GetNormals()), expected);
  }
}

TEST(LambentNormals, SettingsReExecute)
{
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(makeCube());
  const auto executes = [&]
  {
    vtkPolyData* output = normals->GetOutput();
    const vtkMTimeType before = output->GetMTime();
    normals->Update();
    return output->GetMTime() != before;
  };
  EXPECT_TRUE(executes());
  EXPECT_FALSE(executes());
  normals->SetWeightingToMax();
  EXPECT_TRUE(executes());
  normals->ComputeCellNormalsOn();
  EXPECT_TRUE(executes());
  normals->SplittingOn();
  EXPECT_TRUE(executes());
  normals->SetFeatureAngle(90.0);
  EXPECT_TRUE(executes());
  normals->FlipNormalsOn();
  EXPECT_TRUE(executes());
  normals->ComputePointNormalsOff();
  EXPECT_TRUE(executes());
  normals->SetWeightingToMax();
  normals->SetFeatureAngle(90.0);
  EXPECT_FALSE(executes());
}

TEST(LambentNormals, DefaultsAndClamping)
{
  vtkNew<vtkLambentNormals> normals;
  EXPECT_EQ(normals->GetWeighting(), vtkLambentNormals::ANGLE);
  EXPECT_TRUE(normals->GetComputePointNormals());
  EXPECT_FALSE(normals->GetComputeCellNormals());
  EXPECT_FALSE(normals->GetSplitting());
  EXPECT_EQ(normals->GetFeatureAngle(), 30.0);
  EXPECT_FALSE(normals->GetFlipNormals());
  normals->SetFeatureAngle(-1.0);
  EXPECT_EQ(normals->GetFeatureAngle(), 0.0);
  normals->SetFeatureAngle(181.0);
  EXPECT_EQ(normals->GetFeatureAngle(), 180.0);
  normals->SetWeighting(99);
  EXPECT_EQ(normals->GetWeighting(), vtkLambentNormals::MAX);
  normals->SetWeighting(-1);
  EXPECT_EQ(normals->GetWeighting(), vtkLambentNormals::UNIFORM);
}

TEST(LambentNormals, PrintSelfNamesEverySetting)
{
  vtkNew<vtkLambentNormals> normals;
  normals->SetWeightingToMax();
  normals->SetFeatureAngle(12.5);
  normals->SplittingOn();
  std::ostringstream text;
  normals->Print(text);
  for (const char* line : { "Weighting: Max", "ComputePointNormals: On", "ComputeCellNormals: Off",
         "Splitting: On", "FeatureAngle: 12.5", "FlipNormals: Off" })
  {
    EXPECT_NE(text.str().find(line), std::string::npos) << line;
  }
}
