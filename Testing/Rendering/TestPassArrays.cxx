// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of the inputs as arrays of the picture, compared with an interpolation in long double.
#include "Messages.h"
#include "PassRays.h"

#include "vtkDataObject.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkTypeInt32Array.h"

namespace
{
constexpr int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
constexpr int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;
constexpr int width = 61, height = 45;

/// Looks along -z at the unit squares [i, i + 1] x [j, j + 1] at z = 0, one for each pixel.
void lookAtUnitSquares(Studio& studio)
{
  studio.camera->ParallelProjectionOn();
  studio.camera->SetParallelScale(studio.height() / 2.0);
  studio.look({ studio.width() / 2.0, studio.height() / 2.0, 5.0 },
    { studio.width() / 2.0, studio.height() / 2.0, 0.0 });
}

double valueAt(Studio& studio, const char* name, vtkIdType pixel, int component = 0)
{
  return passOf(studio.tracer->GetOutput(), name)->GetComponent(pixel, component);
}

bool isNothing(vtkDataArray* array, vtkIdType pixel)
{
  for (int k = 0; k < array->GetNumberOfComponents(); ++k)
  {
    if (!std::isnan(array->GetComponent(pixel, k)))
    {
      return false;
    }
  }
  return true;
}
}

// Three inputs; the last one has neither array.
TEST(PassArrays, AreInterpolatedAtPointsAndTakenAtCells)
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

// Numbers that float holds become float, others double.
TEST(PassArrays, HaveTypesThatHoldTheirNumbers)
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
      // Ascending in x, and the same all over: interpolated without a rounding.
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

TEST(PassArrays, KeepLargeIntegersAndDoubles)
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
/// The pass of an array of another memory layout but the same numbers.
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

TEST(PassArrays, OfOtherMemoryLayouts)
{
  expectOfLayout<float>(VTK_FLOAT, VTK_FLOAT);
  expectOfLayout<double>(VTK_DOUBLE, VTK_DOUBLE);
  expectOfLayout<int>(VTK_INT, VTK_DOUBLE);
  expectOfLayout<unsigned char>(VTK_UNSIGNED_CHAR, VTK_FLOAT);
}

// Bytes in one input and doubles in the other: the picture holds both.
TEST(PassArrays, OfSeveralInputsAreOfTheWiderType)
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

// In vtkPolyData vertices come first, then lines, polygons and strips.
TEST(PassArrays, OfCellsCountAllCellsOfAMesh)
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
  mesh->SetLines(makeCells({ { 0, 1 }, { 1, 2, 3 } }));
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

// Corners with normals of their own still have the values of their points.
TEST(PassArrays, OfPointsDoNotDependOnNormals)
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

TEST(PassArrays, OfPartsAndMiddleSamplesEqualTheWhole)
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

// The values of an array that changed are those of the next picture; removed arrays are gone.
TEST(PassArrays, FollowTheInput)
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

// A filter that made nothing of nothing still has the array: the form does not change.
TEST(PassArrays, OfEmptyInputsKeepTheirForm)
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
