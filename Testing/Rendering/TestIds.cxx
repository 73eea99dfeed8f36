// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The cell and the input that each pixel shows, in scenes where they are known by construction. The
// core's tests compare the triangles with brute force.
#include "Meshes.h"

#include "vtkCellArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPoints.h"

namespace
{
struct Ids
{
  std::vector<vtkIdType> cells, inputs;
  bool operator==(const Ids& other) const
  {
    return this->cells == other.cells && this->inputs == other.inputs;
  }
};

std::vector<vtkIdType> listOf(vtkImageData* image, const char* name)
{
  auto* array = vtkIdTypeArray::SafeDownCast(image->GetPointData()->GetArray(name));
  std::vector<vtkIdType> list;
  for (vtkIdType k = 0; array && k < array->GetNumberOfTuples(); ++k)
  {
    list.push_back(array->GetValue(k));
  }
  return list;
}

Ids render(Studio& studio)
{
  studio.tracer->GenerateIdsOn();
  studio.tracer->Update();
  vtkImageData* image = studio.tracer->GetOutput();
  return { listOf(image, "CellIds"), listOf(image, "InputIds") };
}

/// Looks along -z at the unit squares [i, i + 1] x [j, j + 1], one for each pixel.
Studio& lookAtUnitSquares(Studio& studio)
{
  studio.camera->ParallelProjectionOn();
  studio.camera->SetParallelScale(studio.height() / 2.0);
  studio.look({ studio.width() / 2.0, studio.height() / 2.0, 5.0 },
    { studio.width() / 2.0, studio.height() / 2.0, 0.0 });
  return studio;
}

/// The unit squares of a row of pixels, for the columns [first, last).
vtkSmartPointer<vtkPolyData> row(int first, int last, double y, double z)
{
  std::vector<Vec> points;
  Polygons squares;
  for (int x = first; x < last; ++x)
  {
    const int n = static_cast<int>(points.size());
    points.insert(
      points.end(), { Vec(x, y, z), Vec(x + 1, y, z), Vec(x + 1, y + 1, z), Vec(x, y + 1, z) });
    squares.push_back({ n, n + 1, n + 2, n + 3 });
  }
  return makeMesh(points, squares);
}
}

TEST(Ids, AreOffByDefault)
{
  Studio studio(4, 1);
  studio.tracer->AddInputDataObject(makeSquare());
  EXPECT_FALSE(studio.tracer->GetGenerateIds());
  studio.tracer->Update();
  EXPECT_EQ(studio.tracer->GetOutput()->GetPointData()->GetNumberOfArrays(), 1);
  studio.tracer->GenerateIdsOn();
  studio.tracer->Update();
  EXPECT_EQ(studio.tracer->GetOutput()->GetPointData()->GetNumberOfArrays(), 3);
  EXPECT_STREQ(studio.tracer->GetOutput()->GetPointData()->GetScalars()->GetName(), "Color");
  studio.tracer->GenerateIdsOff();
  studio.tracer->Update();
  EXPECT_EQ(studio.tracer->GetOutput()->GetPointData()->GetNumberOfArrays(), 1);
}

TEST(Ids, NameTheCellAndTheInput)
{
  Studio studio(5, 3);
  lookAtUnitSquares(studio);
  studio.tracer->AddInputDataObject(row(1, 4, 0, 0.0));
  studio.tracer->AddInputDataObject(row(0, 5, 2, 0.0));
  const Ids ids = render(studio);
  EXPECT_EQ(ids.cells,
    (std::vector<vtkIdType>{ -1, 0, 1, 2, -1, /**/ -1, -1, -1, -1, -1, //
      /**/ 0, 1, 2, 3, 4 }));
  EXPECT_EQ(ids.inputs,
    (std::vector<vtkIdType>{ -1, 0, 0, 0, -1, /**/ -1, -1, -1, -1, -1, //
      /**/ 1, 1, 1, 1, 1 }));
}

TEST(Ids, NearestWins)
{
  Studio studio(4, 1);
  lookAtUnitSquares(studio);
  studio.tracer->AddInputDataObject(row(0, 4, 0, 0.0));
  studio.tracer->AddInputDataObject(row(1, 2, 0, 1.0));
  studio.tracer->AddInputDataObject(row(2, 4, 0, -1.0));
  const Ids ids = render(studio);
  EXPECT_EQ(ids.inputs, (std::vector<vtkIdType>{ 0, 1, 0, 0 }));
  EXPECT_EQ(ids.cells, (std::vector<vtkIdType>{ 0, 0, 2, 3 }));
}

TEST(Ids, TiesGoToTheSmallestInputAndCell)
{
  Studio studio(4, 1);
  lookAtUnitSquares(studio);
  studio.tracer->AddInputDataObject(row(2, 4, 0, 0.0));
  const auto twice = row(0, 4, 0, 0.0); // each square twice; the second time as cells 4 to 7
  for (vtkIdType cell = 0; cell < 4; ++cell)
  {
    const vtkIdType corners[4] = { 4 * cell, 4 * cell + 1, 4 * cell + 2, 4 * cell + 3 };
    twice->GetPolys()->InsertNextCell(4, corners);
  }
  studio.tracer->AddInputDataObject(twice);
  const Ids ids = render(studio);
  EXPECT_EQ(ids.inputs, (std::vector<vtkIdType>{ 1, 1, 0, 0 }));
  EXPECT_EQ(ids.cells, (std::vector<vtkIdType>{ 0, 1, 0, 1 }));
}

// In vtkPolyData vertices come first, then lines, polygons and strips.
TEST(Ids, CountAllCellsOfAMesh)
{
  Studio studio(5, 1);
  lookAtUnitSquares(studio);
  const auto mesh = row(0, 3, 0, 0.0);
  vtkNew<vtkCellArray> vertices, lines, strips;
  vertices->InsertNextCell({ 0 });
  vertices->InsertNextCell({ 1 });
  lines->InsertNextCell({ 0, 1 });
  vtkPoints* points = mesh->GetPoints();
  const vtkIdType n = points->GetNumberOfPoints();
  for (const auto& p : { Vec(3, 0, 0), Vec(3, 1, 0), Vec(4, 0, 0), Vec(4, 1, 0) })
  {
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  strips->InsertNextCell({ n, n + 1, n + 2, n + 3 });
  mesh->SetVerts(vertices);
  mesh->SetLines(lines);
  mesh->SetStrips(strips);
  studio.tracer->AddInputDataObject(mesh);
  EXPECT_EQ(render(studio).cells, (std::vector<vtkIdType>{ 2, 4, 5, 6, -1 }));
}

TEST(Ids, DoNotChangeColours)
{
  Studio studio(101, 67);
  studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
  studio.tracer->AddInputDataObject(makeSphere(12));
  const Picture without = ::render(studio.tracer);
  studio.tracer->GenerateIdsOn();
  EXPECT_SAME_BITS(without, ::render(studio.tracer));
}

TEST(Ids, PartsEqualTheWhole)
{
  Studio studio(101, 67);
  studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
  studio.tracer->AddInputDataObject(makeSphere(12));
  studio.tracer->AddInputDataObject(makeBox(0.8, 0.9, 0.7));
  const Ids whole = render(studio);
  EXPECT_GT(*std::max_element(whole.cells.begin(), whole.cells.end()), 50);
  EXPECT_EQ(*std::max_element(whole.inputs.begin(), whole.inputs.end()), 1);
  const int windows[][4] = { { 50, 50, 33, 33 }, { 31, 64, 32, 33 }, { 7, 93, 5, 61 } };
  for (const auto& w : windows)
  {
    studio.tracer->Modified();
    const int extent[6] = { w[0], w[1], w[2], w[3], 0, 0 };
    studio.tracer->UpdateExtent(extent);
    vtkImageData* image = studio.tracer->GetOutput();
    Ids expected;
    for (int j = w[2]; j <= w[3]; ++j)
    {
      for (int i = w[0]; i <= w[1]; ++i)
      {
        expected.cells.push_back(whole.cells[j * 101 + i]);
        expected.inputs.push_back(whole.inputs[j * 101 + i]);
      }
    }
    EXPECT_EQ(listOf(image, "CellIds"), expected.cells);
    EXPECT_EQ(listOf(image, "InputIds"), expected.inputs);
  }
}
