// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Ghost cells and points.
#include "Blocks.h"
#include "ExpectedErrors.h"

#include "vtkDataSetAttributes.h"
#include "vtkIntArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>

namespace
{
using Flags = std::vector<unsigned char>;

constexpr unsigned char duplicate = vtkDataSetAttributes::DUPLICATECELL;
constexpr unsigned char hidden = vtkDataSetAttributes::HIDDENCELL;
constexpr unsigned char refined = vtkDataSetAttributes::REFINEDCELL;
constexpr unsigned char hiddenPoint = vtkDataSetAttributes::HIDDENPOINT;

void setGhosts(vtkDataSetAttributes* data, const Flags& flags)
{
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(vtkDataSetAttributes::GhostArrayName());
  for (const unsigned char flag : flags)
  {
    array->InsertNextValue(flag);
  }
  data->AddArray(array);
}

/// The polygons whose flag is among these, with all points and no normals.
Mesh makePart(vtkPolyData* mesh, const Flags& flags, const Flags& kept)
{
  Polygons polygons;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (std::count(kept.begin(), kept.end(), flags[static_cast<std::size_t>(cell)]) > 0)
    {
      vtkNew<vtkIdList> ids;
      mesh->GetCellPoints(cell, ids);
      polygons.emplace_back(ids->begin(), ids->end());
    }
  }
  return makeMesh(pointsOf(mesh), polygons);
}

/// The flags of each polygon: `right` if its points are right of the middle, `middle` if on both
/// sides, `left` otherwise.
Flags flagsBySide(vtkPolyData* mesh, unsigned char left, unsigned char middle, unsigned char right)
{
  Flags flags;
  const std::vector<Vec> points = pointsOf(mesh);
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    mesh->GetCellPoints(cell, ids);
    const auto count = std::count_if(ids->begin(), ids->end(),
      [&](vtkIdType id) { return points[static_cast<std::size_t>(id)].x > 0.1; });
    flags.push_back(count == 0 ? left : count == ids->GetNumberOfIds() ? right : middle);
  }
  return flags;
}

Mesh makeBare(int n)
{
  const Mesh mesh = makeSphere(n);
  mesh->GetPointData()->SetNormals(nullptr);
  return mesh;
}

Mesh withGhosts(vtkPolyData* mesh, const Flags& flags)
{
  Mesh result = Mesh::New();
  result->DeepCopy(mesh);
  setGhosts(result->GetCellData(), flags);
  return result;
}

Picture renderInputs(const std::vector<Mesh>& inputs)
{
  Studio studio(61, 43);
  studio.look({ 1.0, 2.0, 4.0 }, Vec(0.0));
  for (const Mesh& input : inputs)
  {
    studio.tracer->AddInputDataObject(input);
  }
  return render(studio.tracer);
}
}

TEST(Ghosts, AreNotDrawn)
{
  Studio studio(6, 1);
  lookAtRow(studio);
  const Mesh mesh = makeRow(0, 6);
  setGhosts(mesh->GetCellData(),
    { 0, duplicate, hidden, refined, 0, static_cast<unsigned char>(duplicate | hidden) });
  studio.tracer->SetInputData(mesh);
  EXPECT_EQ(renderIds(studio, "CellIds"), (Ids{ 0, -1, -1, -1, 4, -1 }));
}

// The array covers all cells, in vtkPolyData's order: vertices, lines, polygons, strips.
TEST(Ghosts, AreCountedAmongAllCells)
{
  Studio studio(6, 1);
  lookAtRow(studio);
  const Mesh mesh = makeRow(0, 6);
  const Polygons all{ { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 8, 9, 10, 11 } };
  mesh->SetPolys(makeCells(all));
  mesh->SetVerts(makeCells({ { 0 }, { 1 } }));
  mesh->SetLines(makeCells({ { 0, 1 } }));
  mesh->SetStrips(makeCells({ { 12, 13, 15, 14 }, { 16, 17, 19, 18 }, { 20, 21, 23, 22 } }));
  setGhosts(mesh->GetCellData(), { 1, 1, 1, 0, 1, 0, 1, 0, 0 });
  studio.tracer->SetInputData(mesh);
  EXPECT_EQ(renderIds(studio, "CellIds"), (Ids{ 3, -1, 5, -1, 7, 8 }));
}

TEST(Ghosts, IncludeCellsWithHiddenPoints)
{
  Studio studio(4, 1);
  lookAtRow(studio);
  const Mesh mesh = makeRow(0, 4);
  Flags flags(16, vtkDataSetAttributes::DUPLICATEPOINT); // which does not matter
  flags[6] = hiddenPoint;
  flags[15] = hiddenPoint;
  setGhosts(mesh->GetPointData(), flags);
  studio.tracer->SetInputData(mesh);
  EXPECT_EQ(renderIds(studio, "CellIds"), (Ids{ 0, -1, 2, -1 }));
}

TEST(Ghosts, KeepCellArraysInPlace)
{
  Studio studio(4, 1);
  lookAtRow(studio);
  const Mesh mesh = makeRow(0, 4);
  setGhosts(mesh->GetCellData(), { 1, 0, 0, 0 });
  vtkNew<vtkFloatArray> values;
  values->SetName("Part");
  for (const float value : { 5.0f, 6.0f, 7.0f, 8.0f })
  {
    values->InsertNextValue(value);
  }
  mesh->GetCellData()->AddArray(values);
  setCellNormals(mesh, { Vec(1.0), { 0, 0, 1 }, { 0, 1, 1 }, { 1, 0, 1 } });
  studio.property->SetInterpolationToFlat();
  studio.tracer->SetInputData(mesh);
  studio.tracer->AddPassArray(vtkDataObject::FIELD_ASSOCIATION_CELLS, "Part");
  studio.tracer->GenerateNormalsOn();
  studio.tracer->Update();
  vtkPointData* const data = studio.tracer->GetOutput()->GetPointData();
  EXPECT_TRUE(std::isnan(data->GetArray("Part")->GetComponent(0, 0)));
  EXPECT_EQ(data->GetArray("Part")->GetComponent(1, 0), 6.0);
  EXPECT_EQ(data->GetArray("Part")->GetComponent(3, 0), 8.0);
  EXPECT_EQ(data->GetArray("Normals")->GetComponent(1, 2), 1.0);
  EXPECT_NEAR(data->GetArray("Normals")->GetComponent(2, 1), std::sqrt(0.5), 1e-6);
}

// Two pieces with a layer of ghost cells between them show the sphere, to the bit; without ghosts
// there is a seam.
TEST(Ghosts, ContributeToNormalsIfDuplicate)
{
  const Mesh whole = makeBare(9);
  const Flags left = flagsBySide(whole, 0, 0, duplicate);
  const Flags right = flagsBySide(whole, duplicate, duplicate, 0);
  const Picture expected = renderInputs({ whole });
  EXPECT_SAME_BITS(renderInputs({ withGhosts(whole, left), withGhosts(whole, right) }), expected);
  EXPECT_NE(renderInputs({ makePart(whole, left, { 0 }), makePart(whole, right, { 0 }) }).bits(),
    expected.bits());
}

TEST(Ghosts, DoNotContributeToNormalsIfHidden)
{
  const Mesh whole = makeBare(9);
  for (const unsigned char flag : { hidden, refined })
  {
    const Flags flags = flagsBySide(whole, 0, 0, flag);
    EXPECT_SAME_BITS(
      renderInputs({ withGhosts(whole, flags) }), renderInputs({ makePart(whole, flags, { 0 }) }));
  }
}

// Corners have normals of their own at sharp edges, for triangles and for other polygons.
TEST(Ghosts, KeepSharpEdges)
{
  const Mesh box = makeBox(0.7, 0.8, 0.9);
  Polygons halves;
  for (vtkIdType cell = 0; cell < box->GetNumberOfCells(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    box->GetCellPoints(cell, ids);
    halves.push_back({ ids->GetId(0), ids->GetId(1), ids->GetId(2) });
    halves.push_back({ ids->GetId(0), ids->GetId(2), ids->GetId(3) });
  }
  for (const Mesh& mesh : { box, makeMesh(pointsOf(box), halves) })
  {
    const bool isBox = mesh == box;
    const Flags flags = isBox ? Flags{ 1, 0, 0, 0, 0, 0 }
                              : Flags{ 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }; // the left side
    EXPECT_SAME_BITS(renderInputs({ withGhosts(mesh, flags) }), renderInputs({ mesh }));
  }
}

TEST(Ghosts, OfNoneKeepEveryBit)
{
  const Mesh mesh = makeBare(7);
  const Flags flags(static_cast<std::size_t>(mesh->GetNumberOfCells()), 0);
  EXPECT_SAME_BITS(renderInputs({ withGhosts(mesh, flags) }), renderInputs({ mesh }));
}

TEST(Ghosts, MayBeAll)
{
  const Mesh mesh = makeBare(7);
  const Flags flags(static_cast<std::size_t>(mesh->GetNumberOfCells()), duplicate);
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(withGhosts(mesh, flags));
  EXPECT_EQ(render(studio.tracer).count(Studio::background()), 32 * 24);
  EXPECT_TRUE(messages.errors().empty() && messages.warnings().empty());
}

TEST(Ghosts, AreNotFramedByResetCamera)
{
  Studio one, other;
  const Mesh mesh = makeRow(0, 6);
  setGhosts(mesh->GetCellData(), { 0, 0, duplicate, duplicate, hidden, hidden });
  one.tracer->SetInputData(mesh);
  other.tracer->SetInputData(makeRow(0, 2));
  one.tracer->ResetCamera();
  other.tracer->ResetCamera();
  EXPECT_EQ(one.position(), other.position());
}

// What is not drawn needs no finite points.
TEST(Ghosts, CauseNoWarningAboutPoints)
{
  const Mesh mesh = makeRow(0, 3);
  mesh->GetPoints()->SetPoint(5, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  setGhosts(mesh->GetCellData(), { 0, hidden, 0 });
  Studio studio(3, 1);
  lookAtRow(studio);
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(mesh);
  EXPECT_EQ(renderIds(studio, "CellIds"), (Ids{ 0, -1, 2 }));
  EXPECT_TRUE(messages.warnings().empty());
}

TEST(Ghosts, OfWrongLengthOrTypeAreAnError)
{
  const auto expect = [](vtkDataArray* array, bool isPerCell, const std::string& what)
  {
    array->SetName("vtkGhostType");
    const Mesh mesh = makeRow(0, 3); // 3 cells, 12 points
    expectError(
      [&](Studio& studio)
      {
        isPerCell ? mesh->GetCellData()->AddArray(array) : mesh->GetPointData()->AddArray(array);
        studio.tracer->AddInputDataObject(mesh);
      },
      { std::string("Input 1: the ") + (isPerCell ? "cell" : "point") + " array \"vtkGhostType\"",
        what, isPerCell ? "there are 3 cells" : "there are 12 points", "remove it" },
      [](Studio& studio) { studio.tracer->RemoveInputConnection(0, 1); });
  };
  vtkNew<vtkUnsignedCharArray> tooShort, pairs, none;
  tooShort->SetNumberOfTuples(2);
  tooShort->Fill(0);
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(3);
  pairs->Fill(0);
  vtkNew<vtkIntArray> integers;
  integers->SetNumberOfTuples(12);
  integers->Fill(0);
  expect(tooShort, true, "a vtkUnsignedCharArray of 2 tuples of 1 components");
  expect(pairs, true, "3 tuples of 2 components");
  expect(none, false, "0 tuples");
  expect(integers, false, "a vtkIntArray of 12 tuples");
}
