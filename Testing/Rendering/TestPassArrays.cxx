// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Pass arrays, compared with an interpolation in long double.
#include "Messages.h"
#include "PassRays.h"

#include "vtkDataObject.h"

namespace
{
constexpr int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
constexpr int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
constexpr int width = 61, height = 45;
}

// There are three inputs, the last of which has neither array.
TEST(PassArrays, PointArraysAreInterpolatedAndCellArraysAreNot)
{
  for (const bool isParallel : { false, true })
  {
    Studio studio(width, height);
    studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
    studio.camera->SetParallelProjection(isParallel);
    studio.camera->SetParallelScale(1.75);
    const Mesh meshes[] = { makeSphere(12), makeBox(0.9, 0.8, 1.3), makeSquare(3.0, -1.5) };
    LongRays rays;
    for (int k = 0; k < 3; ++k)
    {
      if (k < 2)
      {
        addArray(meshes[k], points, VTK_DOUBLE, "Flow", 3, 10u + k);
        addArray(meshes[k], cells, VTK_INT, "Part", 2, 20u + k);
      }
      studio.tracer->AddInputDataObject(meshes[k]);
      rays.add(meshes[k]);
    }
    studio.tracer->AddPassArray(points, "Flow");
    studio.tracer->AddPassArray(cells, "Part");
    const Messages messages(studio.tracer);
    studio.tracer->Update();
    EXPECT_TRUE(messages.warnings().empty());
    vtkDataArray* const flow = passOf(studio.tracer->GetOutput(), "Flow");
    vtkDataArray* const part = passOf(studio.tracer->GetOutput(), "Part");
    int seen[4] = {};
    for (vtkIdType pixel = 0; pixel < width * height; ++pixel)
    {
      const LongHit hit = rays.find(studio.ray(pixel % width, pixel / width));
      if (!hit.isCertain)
      {
        continue;
      }
      ++seen[hit.isHit() ? hit.input : 3];
      if (!hit.isHit() || hit.input == 2)
      {
        EXPECT_TRUE(isNothing(flow, pixel) && isNothing(part, pixel));
        continue;
      }
      for (int k = 0; k < 3; ++k)
      {
        vtkDataArray* const from = meshes[hit.input]->GetPointData()->GetArray("Flow");
        EXPECT_NEAR(
          flow->GetComponent(pixel, k), static_cast<double>(hit.interpolate(from, k)), 1e-10);
      }
      for (int k = 0; k < 2; ++k)
      {
        vtkDataArray* const from = meshes[hit.input]->GetCellData()->GetArray("Part");
        EXPECT_EQ(part->GetComponent(pixel, k), from->GetComponent(hit.cell, k));
      }
    }
    for (const int count : seen)
    {
      EXPECT_GT(count, 100);
    }
  }
}

// In vtkPolyData, vertices come first, then lines, polygons and strips.
TEST(PassArrays, CellArraysIncludeVerticesAndLines)
{
  Studio studio(4, 1);
  lookAtUnitSquares(studio);
  std::vector<Vec> corners;
  for (int x = 0; x <= 4; ++x)
  {
    corners.insert(corners.end(), { Vec(x, -1.0, 0.0), Vec(x, 2.0, 0.0) });
  }
  const Mesh mesh = makeMesh(corners, { { 0, 2, 3, 1 }, { 2, 4, 5, 3 } });
  mesh->SetVerts(makeCells({ { 0 }, { 1 }, { 2 } }));
  mesh->SetLines(makeCells({ { 0, 0 }, { 1, 1, 1 } }));
  mesh->SetStrips(makeCells({ { 4, 6, 5, 7 }, { 6, 8, 7, 9 } }));
  const auto array = addArray(mesh, cells, VTK_FLOAT, "Tens", 1);
  ASSERT_EQ(array->GetNumberOfTuples(), 9);
  for (vtkIdType k = 0; k < 9; ++k)
  {
    array->SetComponent(k, 0, 10.0 * k);
  }
  studio.tracer->SetInputData(mesh);
  studio.tracer->AddPassArray(cells, "Tens");
  studio.tracer->Update();
  for (vtkIdType pixel = 0; pixel < 4; ++pixel)
  {
    EXPECT_EQ(valueAt(studio, "Tens", pixel), 50.0 + 10.0 * pixel);
  }
}

// Corners with separate normals still have the values of their points.
TEST(PassArrays, PointArraysDoNotDependOnNormals)
{
  const auto flow = [](bool isSmooth, bool isSplit)
  {
    Studio studio(width, height);
    studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
    studio.property->SetInterpolation(isSmooth ? VTK_PHONG : VTK_FLAT);
    studio.tracer->SetSplitting(isSplit);
    const Mesh box = makeBox(0.9, 0.8, 1.3);
    addArray(box, points, VTK_DOUBLE, "Flow", 1);
    studio.tracer->SetInputData(box);
    studio.tracer->AddPassArray(points, "Flow");
    studio.tracer->Update();
    vtkDataArray* const array = passOf(studio.tracer->GetOutput(), "Flow");
    std::string bits;
    for (vtkIdType pixel = 0; pixel < array->GetNumberOfTuples(); ++pixel)
    {
      bits += tupleBits(array, pixel);
    }
    return bits;
  };
  EXPECT_EQ(flow(true, true), flow(false, true));
  EXPECT_EQ(flow(true, false), flow(false, true));
}

TEST(PassArrays, PartsAndMiddleSamplesEqualTheWhole)
{
  const auto setUp = [](Studio& studio, int samples)
  {
    studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
    const Mesh ball = makeSphere(9);
    addArray(ball, points, VTK_FLOAT, "Flow", 2);
    addArray(ball, cells, VTK_SHORT, "Part", 1);
    studio.tracer->SetInputData(ball);
    studio.tracer->AddPassArray(points, "Flow");
    studio.tracer->AddPassArray(cells, "Part");
    studio.tracer->SetSupersampling(samples);
  };
  constexpr int n = 3;
  Studio whole(width, height), part(width, height), larger(n * width, n * height);
  setUp(whole, n);
  setUp(part, n);
  setUp(larger, 1);
  whole.tracer->Update();
  larger.tracer->Update();
  const int extent[6] = { 11, 50, 7, 40, 0, 0 };
  part.tracer->UpdateExtent(extent);
  vtkIdType k = 0;
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    for (int i = extent[0]; i <= extent[1]; ++i, ++k)
    {
      expectSameArrays(part.tracer->GetOutput(), k, whole.tracer->GetOutput(), j * width + i);
      for (const char* name : { "Flow", "Part" })
      {
        EXPECT_EQ(tupleBits(passOf(whole.tracer->GetOutput(), name), j * width + i),
          tupleBits(passOf(larger.tracer->GetOutput(), name),
            static_cast<vtkIdType>(n * j + n / 2) * n * width + n * i + n / 2));
      }
    }
  }
}

// The next picture has the values of a changed array, and no removed array.
TEST(PassArrays, ChangesAreRendered)
{
  Studio studio(2, 2);
  const Mesh square = makeSquare();
  const auto array = addArray(square, points, VTK_FLOAT, "Heat", 1);
  array->Fill(3.0);
  studio.tracer->SetInputData(square);
  studio.tracer->AddPassArray(points, "Heat");
  studio.tracer->Update();
  EXPECT_EQ(valueAt(studio, "Heat", 0), 3.0);
  array->Fill(4.0);
  array->Modified();
  studio.tracer->Update();
  EXPECT_EQ(valueAt(studio, "Heat", 0), 4.0);
  studio.tracer->RemoveAllPassArrays();
  studio.tracer->Update();
  EXPECT_EQ(studio.tracer->GetOutput()->GetPointData()->GetNumberOfArrays(), 1);
}
