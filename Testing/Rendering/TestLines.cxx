// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines, vertices, wireframes and points: which cells they show, how wide, in which colours.
#include "LineBoard.h"
#include "Messages.h"

#include "vtkDataObject.h"
#include "vtkUnsignedCharArray.h"

TEST(Lines, SurfacesShowVerticesLinesAndFaces)
{
  Board board;
  const Messages messages(board.tracer);
  board.tracer->SetInputData(makeAll());
  EXPECT_EQ(board.count(0), 2);
  EXPECT_EQ(board.count(1), 9 + 4); // a pixel on each unit, and the joint once
  EXPECT_EQ(board.count(2), 5);
  EXPECT_EQ(board.id(2, 2), 0);
  EXPECT_EQ(board.id(5, 2), 0);
  EXPECT_EQ(board.id(7, 20), 1);
  EXPECT_EQ(board.id(10, 18), 1);
  EXPECT_EQ(board.id(2, 8), 2);
  EXPECT_EQ(board.id(17, 7), 3);
  EXPECT_EQ(board.id(23, 7), 4);
  EXPECT_EQ(board.id(18, 16), 5);
  EXPECT_TRUE(messages.errors().empty());
  EXPECT_TRUE(messages.warnings().empty());
}

TEST(Lines, HaveTheWidthsOfTheProperty)
{
  Board board;
  board.property->SetLineWidth(3.0);
  board.property->SetPointSize(5.0);
  board.tracer->SetInputData(makeAll());
  for (int k = -3; k <= 3; ++k)
  {
    EXPECT_EQ(board.id(7, 20 + k) == 1, std::abs(k) <= 1) << k;
  }
  int disc = 0;
  for (int pixel = 0; pixel < 49; ++pixel)
  {
    const int i = pixel % 7 - 3, j = pixel / 7 - 3;
    disc += 4 * (i * i + j * j) <= 25;
  }
  EXPECT_EQ(board.count(0), 2 * disc - 6); // the discs overlap
  board.tracer->SetSupersampling(3);
  EXPECT_EQ(board.count(0), 2 * disc - 6);
  const Vec half = render(board.tracer).at(7, 22);
  EXPECT_EQ(half, Studio::background());
}

TEST(Lines, WireframesShowTheEdgesOfCells)
{
  Board board;
  const Messages messages(board.tracer);
  board.property->SetRepresentationToWireframe();
  board.tracer->SetInputData(makeAll());
  EXPECT_EQ(board.count(0), 2);
  EXPECT_EQ(board.count(1), 13);
  EXPECT_EQ(board.count(3), 24); // all around, no diagonal
  EXPECT_EQ(board.count(4), 17); // without the common edge
  EXPECT_EQ(board.id(20, 7), 3);
  EXPECT_EQ(board.id(17, 7), -1);
  EXPECT_EQ(board.id(16, 17), 5);
  EXPECT_EQ(board.id(20, 17), 5); // between the triangles of the strip
  EXPECT_EQ(board.id(20, 20), 5);
  EXPECT_EQ(board.id(18, 16), -1);
  EXPECT_TRUE(messages.warnings().empty());
}

TEST(Lines, PointsShowThePointsThatCellsUse)
{
  Board board;
  const Messages messages(board.tracer);
  board.property->SetRepresentationToPoints();
  board.tracer->SetInputData(makeAll());
  const int counts[] = { 2, 3, 2, 4, 2, 4 };
  for (int cell = 0; cell < 6; ++cell)
  {
    EXPECT_EQ(board.count(cell), counts[cell]) << cell;
  }
  EXPECT_EQ(board.id(20, 4), 3);
  EXPECT_EQ(board.id(30, 22), -1); // of no cell
  EXPECT_TRUE(messages.warnings().empty());
}

TEST(Lines, VertexVisibilityMarksPointsInItsColour)
{
  Board board;
  const Messages messages(board.tracer);
  board.property->LightingOn();
  board.property->VertexVisibilityOn();
  board.property->SetVertexColor(0.25, 0.5, 0.75);
  board.property->SetDiffuseColor(1.0, 0.0, 0.0);
  board.tracer->SetInputData(makeAll());
  const Picture picture = render(board.tracer);
  EXPECT_EQ(picture.count({ 0.25, 0.5, 0.75 }), 17);
  EXPECT_EQ(picture.at(20, 4), Vec(0.25, 0.5, 0.75));
  EXPECT_EQ(picture.at(17, 4), Vec(1.0, 0.0, 0.0));
  EXPECT_EQ(board.id(20, 4), 3); // the first cell that uses the point
  EXPECT_TRUE(messages.warnings().empty());

  board.property->SetPointSize(9.0);
  board.property->RenderPointsAsSpheresOn(); // lit
  const Picture round = render(board.tracer);
  EXPECT_EQ(round.at(20, 4), Vec(0.25, 0.5, 0.75));
  EXPECT_LT(round.at(20, 1).y, 0.45);
  EXPECT_GT(round.at(20, 1).y, 0.1);
}

TEST(Lines, HaveTheColoursOfCells)
{
  for (const int representation : { VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS })
  {
    Board board;
    const Mesh mesh = makeAll();
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    for (int cell = 0; cell < 6; ++cell)
    {
      colors->InsertNextTuple3(51 * cell, 255 - 51 * cell, 0);
    }
    mesh->GetCellData()->SetScalars(colors);
    board.property->SetRepresentation(representation);
    board.tracer->SetInputData(mesh);
    board.tracer->SetInputScalarVisibility(0, true);
    const Picture picture = render(board.tracer);
    for (int pixel = 0; pixel < 32 * 24; ++pixel)
    {
      const int cell = board.id(pixel % 32, pixel / 32);
      if (cell >= 0)
      {
        expectColor(picture.at(pixel % 32, pixel / 32), { 0.2 * cell, 1.0 - 0.2 * cell, 0.0 },
          pixelName(pixel % 32, pixel / 32));
      }
    }
  }
}

TEST(Lines, InterpolateColoursAndPassesOfPoints)
{
  Board board;
  const Mesh mesh = makeAll();
  vtkNew<vtkDoubleArray> heat;
  vtkNew<vtkFloatArray> cells;
  heat->SetName("Heat");
  cells->SetName("Number");
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    heat->InsertNextValue(mesh->GetPoint(k)[0] - 0.5);
  }
  for (int cell = 0; cell < 6; ++cell)
  {
    cells->InsertNextValue(10.0f * cell);
  }
  mesh->GetPointData()->AddArray(heat);
  mesh->GetCellData()->AddArray(cells);
  board.property->SetRepresentationToWireframe();
  board.tracer->SetInputData(mesh);
  board.tracer->AddPassArray(vtkDataObject::FIELD_ASSOCIATION_POINTS, "Heat");
  board.tracer->AddPassArray(vtkDataObject::FIELD_ASSOCIATION_CELLS, "Number");
  EXPECT_NEAR(board.at("Heat", 5, 20), 5.0, 1e-12);
  EXPECT_NEAR(board.at("Heat", 17, 10), 17.0, 1e-12);
  EXPECT_NEAR(board.at("Heat", 20, 7), 20.0, 1e-12);
  EXPECT_EQ(board.at("Number", 5, 20), 10.0);
  EXPECT_EQ(board.at("Number", 24, 4), 40.0);
  board.tracer->SetInputScalarVisibility(0, true);
  board.tracer->SetInputColorArray(0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Heat");
  const Vec left = render(board.tracer).at(2, 20), right = render(board.tracer).at(26, 4);
  EXPECT_NE(left, right);
}

// Depth is that of the centre line, less the bulge.
TEST(Lines, HaveTheirDepth)
{
  Board board;
  board.tracer->GenerateDepthOn();
  const Mesh mesh = makeMesh({ { 4.5, 4.5, -2.0 }, { 20.5, 4.5, 2.0 } }, {});
  mesh->SetLines(makeCells({ { 0, 1 } }));
  board.tracer->SetInputData(mesh);
  board.property->SetLineWidth(1.5);
  EXPECT_NEAR(board.at("Depth", 12, 4), 5.0 - 0.75, 1e-6);
  EXPECT_NEAR(board.at("Depth", 8, 4), 6.0 - 0.75, 1e-6);
}

TEST(Lines, LieOnTheirFaces)
{
  Board board;
  const Mesh square =
    makeMesh({ { 4.0, 4.0, 0.0 }, { 24.0, 4.0, 3.0 }, { 24.0, 20.0, 3.0 }, { 4.0, 20.0, 0.0 } },
      { { 0, 1, 2, 3 } });
  square->SetLines(makeCells({ { 0, 2 } }));
  board.tracer->SetInputData(square);
  Board alone;
  const Mesh line = Mesh::New();
  line->SetPoints(square->GetPoints());
  line->SetLines(square->GetLines());
  alone.tracer->SetInputData(line);
  EXPECT_GT(alone.count(0), 18);
  EXPECT_EQ(board.count(0), alone.count(0));
  EXPECT_GT(board.count(1), 200);
}
