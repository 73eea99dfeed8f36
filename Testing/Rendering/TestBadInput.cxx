// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// An error in an input names the input's number, the array or the cell, and the remedy. The output
// is then empty, and the next good picture is right.
#include "Meshes.h"
#include "Messages.h"

#include "vtkTrivialProducer.h"
#include "vtkTypeInt64Array.h"

#include <limits>

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();
const double infinite = std::numeric_limits<double>::infinity();

/// Renders a good input 0 and a bad input 1, and expects the parts in the error.
void expectError(
  vtkPolyData* bad, const std::vector<std::string>& parts, int interpolation = VTK_PHONG)
{
  Studio studio;
  Messages messages(studio.tracer);
  studio.property->SetInterpolation(interpolation);
  studio.tracer->AddInputDataObject(makeSphere(6));
  const Picture expected = render(studio.tracer);
  studio.tracer->AddInputDataObject(bad);
  studio.tracer->Update();
  expectMessage(messages.errors(), parts);
  expectMessage(messages.errors(), { "Input 1:" });
  EXPECT_TRUE(messages.warnings().empty());
  EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(studio.tracer->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);

  studio.tracer->RemoveInputConnection(0, 1);
  messages.clear();
  const Picture again = render(studio.tracer);
  EXPECT_SAME_BITS(expected, again);
  EXPECT_EQ(messages.errors(), std::vector<std::string>());
  EXPECT_EQ(messages.executive(), std::vector<std::string>());
}
}

TEST(BadInput, CellsWithMissingPoints)
{
  for (vtkIdType wrong : { vtkIdType(4), vtkIdType(-1), vtkIdType(1) << 32, VTK_ID_MAX })
  {
    for (int interpolation : { VTK_PHONG, VTK_FLAT })
    {
      const std::string point = "uses point " + std::to_string(wrong);
      const std::vector<std::string> parts{ "cell 4 ", point, "4 points", "0 to 3",
        "Correct the connectivity" };
      // The third polygon, after a vertex and a line, as a triangle, a quad and a strip.
      Mesh mesh = makeSquare();
      mesh->SetVerts(makeCells({ { 0 } }));
      mesh->SetLines(makeCells({ { 0, 1 } }));
      mesh->SetPolys(makeCells({ { 0, 1, 2 }, { 0, 2, 3 }, { 0, wrong, 2 }, { wrong, 1, 2 } }));
      expectError(mesh, parts, interpolation);
      mesh->SetPolys(makeCells({ { 0, 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, wrong, 3 } }));
      expectError(mesh, parts, interpolation);
      mesh->SetPolys(makeCells({ { 0, 1, 2, 3 }, { 0, 2, 3 } }));
      mesh->SetStrips(makeCells({ { 0, 1, 2, wrong } }));
      expectError(mesh, parts, interpolation);
    }
  }
}

TEST(BadInput, CellsWithoutAnyPoints)
{
  Mesh mesh = Mesh::New();
  mesh->SetPolys(makeCells({ { 0, 1, 2 } }));
  expectError(mesh, { "cell 0 ", "uses point 0", "no points" });
  mesh->SetPoints(vtkNew<vtkPoints>());
  expectError(mesh, { "cell 0 ", "uses point 0", "no points" });
}

// vtkPoints rejects an array of two components, but does not notice if its array changes later.
TEST(BadInput, PointsOfTwoComponents)
{
  Mesh mesh = makeSquare();
  mesh->GetPoints()->GetData()->SetNumberOfComponents(2);
  mesh->GetPoints()->GetData()->SetNumberOfTuples(4);
  expectError(mesh, { "points have 2 components, not 3" });
}

TEST(BadInput, PointNormals)
{
  Mesh mesh = makeSquare();
  setPointNormals(mesh, std::vector<Vec>(3, { 0.0, 0.0, 1.0 }));
  expectError(mesh,
    { "point normals", "\"PointNormals\"", "3 tuples of 3", "4 points", "Remove the array",
      "vtkLambentNormals" });
  setPointNormals(mesh, std::vector<Vec>(5, { 0.0, 0.0, 1.0 }));
  expectError(mesh, { "point normals", "\"PointNormals\"", "5 tuples of 3", "4 points" });

  // vtkDataSetAttributes rejects normals of two components, but does not notice a later change.
  setPointNormals(mesh, std::vector<Vec>(4, { 0.0, 0.0, 1.0 }));
  mesh->GetPointData()->GetNormals()->SetName(nullptr);
  mesh->GetPointData()->GetNormals()->SetNumberOfComponents(2);
  mesh->GetPointData()->GetNormals()->SetNumberOfTuples(4);
  expectError(mesh, { "point normals", "without a name", "4 tuples of 2", "a tuple of 3" });
}

TEST(BadInput, CellNormals)
{
  Mesh mesh = makeSquare();
  mesh->SetVerts(makeCells({ { 0 }, { 1 } }));
  setCellNormals(mesh, std::vector<Vec>(1, { 0.0, 0.0, 1.0 }));
  expectError(mesh,
    { "cell normals", "\"CellNormals\"", "1 tuples of 3", "3 cells", "Remove the array" },
    VTK_FLAT);
}

// Bad normals are harmless if no pixel needs them.
TEST(BadInput, UnusedNormalsAreNotChecked)
{
  Mesh mesh = makeSquare();
  setPointNormals(mesh, std::vector<Vec>(3, { 0.0, 0.0, 1.0 }));
  setCellNormals(mesh, std::vector<Vec>(7, { 0.0, 0.0, 1.0 }));
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(mesh);
  studio.tracer->UsePointNormalsOff();
  EXPECT_EQ(render(studio.tracer).count(Studio::background()), 0);
  studio.property->LightingOff();
  EXPECT_EQ(render(studio.tracer).count(Studio::background()), 0);
  EXPECT_TRUE(messages.errors().empty());
}

TEST(BadInput, OffsetsThatDecrease)
{
  for (int kind : { 0, 1 })
  {
    vtkNew<vtkTypeInt64Array> offsets, connectivity;
    for (vtkIdType offset : { 0, 6, 3, 9 })
    {
      offsets->InsertNextValue(offset);
    }
    for (vtkIdType id : { 0, 1, 2, 0, 2, 3, 0, 1, 3 })
    {
      connectivity->InsertNextValue(id);
    }
    vtkNew<vtkCellArray> cells;
    cells->SetData(offsets, connectivity);
    Mesh mesh = makeSquare();
    const auto expectBroken = [&]()
    {
      if (kind == 0)
      {
        mesh->SetPolys(cells);
        expectError(mesh, { "offsets of the polygons", "decrease or reach beyond", "Rebuild" });
      }
      else
      {
        mesh->SetPolys(nullptr);
        mesh->SetStrips(cells);
        expectError(mesh, { "offsets of the strips", "decrease or reach beyond", "Rebuild" });
      }
    };
    expectBroken();
    offsets->SetValue(1, 3);
    offsets->SetValue(2, 6);
    offsets->SetValue(3, 12); // beyond the connectivity
    expectBroken();
    offsets->SetValue(3, 9);
    offsets->SetValue(0, -3);
    expectBroken();
  }
}

TEST(BadInput, NonFiniteCoordinatesAreSkippedWithOneWarning)
{
  for (double bad : { notANumber, infinite, -infinite })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      // Two vertices; then cells with the bad point 4, and cells without it.
      std::vector<Vec> points = pointsOf(makeSquare());
      points.emplace_back(0.0, 0.0, 1.0);
      points.back()[axis] = bad;
      Mesh mesh = makeMesh(
        points, { { 0, 1, 2, 3 }, { 0, 1, 4 }, { 1, 2, 3, 4, 0 }, { 0, 1, 2, 3 }, { 4, 4, 4, 4 } });
      mesh->SetVerts(makeCells({ { 4 }, { 1 } }));
      Studio studio;
      Messages messages(studio.tracer);
      studio.tracer->AddInputDataObject(makeMesh({}, {}));
      studio.tracer->AddInputDataObject(mesh);
      EXPECT_EQ(render(studio.tracer).count(Vec(1.0)), 32 * 24); // the other cells are drawn
      expectMessage(messages.warnings(),
        { "4 cells have a point that is not finite", "the first is cell 0 of input 1", "Remove" });
      EXPECT_TRUE(messages.errors().empty());
      messages.clear();
      mesh->GetPoints()->SetPoint(4, 0.0, 0.0, -1.0);
      mesh->Modified();
      studio.tracer->Update();
      EXPECT_TRUE(messages.warnings().empty());
    }
  }
}

TEST(BadInput, ASingleNonFiniteCell)
{
  std::vector<Vec> points = pointsOf(makeSquare());
  points[2].y = notANumber;
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(makeMesh(points, { { 0, 1, 3 }, { 0, 1, 2 } }));
  studio.tracer->SetCamera(nullptr); // the default view ignores the bad point
  EXPECT_GT(render(studio.tracer).count(Vec(1.0)), 100);
  expectMessage(messages.warnings(),
    { "1 cell has a point that is not finite", "the first is cell 1 of input 0" });
}

// A point that is not finite is harmless if no cell uses it.
TEST(BadInput, UnusedNonFinitePoint)
{
  std::vector<Vec> points = pointsOf(makeSquare());
  points.emplace_back(notANumber);
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(makeMesh(points, { { 0, 1, 2, 3 } }));
  EXPECT_EQ(render(studio.tracer).count(Vec(1.0)), 32 * 24);
  EXPECT_TRUE(messages.warnings().empty() && messages.errors().empty());
}

TEST(BadInput, ZeroAreaTrianglesAreNeverHit)
{
  Studio studio(33, 33);
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(
    makeMesh({ { -9.0, 0.0, 0.0 }, { 9.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 } },
      { { 0, 1, 2 }, { 0, 0, 3 }, { 2, 2, 2 }, { 1, 2, 0, 1 } }));
  for (int interpolation : { VTK_PHONG, VTK_FLAT })
  {
    studio.property->SetInterpolation(interpolation);
    EXPECT_EQ(render(studio.tracer).count(Studio::background()), 33 * 33);
  }
  EXPECT_TRUE(messages.warnings().empty() && messages.errors().empty());
}

TEST(BadInput, LightExactlyOnTheSurface)
{
  for (double cone : { 180.0, 20.0 })
  {
    Studio studio(9, 9);
    studio.reflect({ 0.5, 0.25, 1.0 }, { 0.125, 0.5, 0.25 });
    studio.tracer->SetInputData(makeSquare(128.0));
    auto light = makeLight({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, -1.0 }, { 1.0, 0.5, 0.25 }, true);
    light->SetConeAngle(cone);
    light->SetAttenuationValues(1.0, 0.5, 0.25);
    studio.tracer->AddLight(light);
    const Picture picture = render(studio.tracer); // the central ray hits the light's position
    EXPECT_EQ(picture.at(4, 4), Vec(0.125, 0.25, 0.0625));
    for (int k = 0; k < 81; ++k)
    {
      EXPECT_TRUE(std::isfinite(picture.at(k % 9, k / 9).x)) << pixelName(k % 9, k / 9);
    }
  }
}

TEST(BadInput, EmptyScenesShowTheBackground)
{
  Studio studio;
  Messages messages(studio.tracer);
  studio.tracer->SetCamera(nullptr);
  studio.tracer->AddInputDataObject(Mesh::New());
  studio.tracer->AddInputDataObject(makeMesh({}, {}));
  studio.tracer->AddInputDataObject(makeMesh({ Vec(0.0), Vec(1.0) }, {})); // points without cells
  EXPECT_EQ(render(studio.tracer).count(Studio::background()), 32 * 24);
  EXPECT_TRUE(messages.warnings().empty() && messages.errors().empty());
}

// A producer without data, or with data of another type, causes VTK's own error.
TEST(BadInput, ConnectionsWithoutAMesh)
{
  for (int kind : { 0, 1 })
  {
    Studio studio;
    Messages messages(studio.tracer);
    studio.tracer->SetInputData(makeSquare());
    studio.tracer->Update();
    vtkNew<vtkTrivialProducer> producer;
    vtkNew<vtkImageData> image;
    producer->SetOutput(kind == 0 ? nullptr : image.Get());
    studio.tracer->SetInputConnection(producer->GetOutputPort());
    studio.tracer->Update();
    EXPECT_FALSE(messages.executive().empty());
    messages.clear();
    studio.tracer->ResetCamera();
    EXPECT_TRUE(messages.errors().empty());
    studio.tracer->SetInputData(makeSquare());
    EXPECT_EQ(render(studio.tracer).count(Studio::background()), 0);
  }
}
