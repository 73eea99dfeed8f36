// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines of inputs with ghosts, transforms, blocks and normals, and their normals.
#include "Blocks.h"
#include "LineBoard.h"

#include "vtkMatrix4x4.h"
#include "vtkUnsignedCharArray.h"

TEST(LineInputs, OfGhostsAreLeftOut)
{
  const auto ghosts = [](vtkDataSetAttributes* to, std::initializer_list<unsigned char> flags)
  {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetName(vtkDataSetAttributes::GhostArrayName());
    for (const unsigned char flag : flags)
    {
      array->InsertNextValue(flag);
    }
    to->AddArray(array);
  };
  for (const int representation : { VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS })
  {
    Board board;
    board.property->SetRepresentation(representation);
    const Mesh mesh = makeAll();
    ghosts(mesh->GetCellData(), { 1, 0, 32, 8, 0, 0 });
    board.tracer->SetInputData(mesh);
    for (const int cell : { 0, 2, 3 })
    {
      EXPECT_EQ(board.count(cell), 0) << cell;
    }
    for (const int cell : { 1, 4, 5 })
    {
      EXPECT_GT(board.count(cell), 0) << cell;
    }
    if (representation != VTK_SURFACE)
    {
      EXPECT_EQ(board.id(20, 4), 4); // of the second square, as the first is hidden
    }
    const Mesh hidden = makeAll();
    ghosts(hidden->GetPointData(), { 0, 0, 2, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0 });
    board.tracer->SetInputData(hidden);
    EXPECT_EQ(board.count(1), 0);
    EXPECT_EQ(board.count(4), 0);
    EXPECT_GT(board.count(3), 0);
  }
}

TEST(LineInputs, AreTransformed)
{
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, -0.5); // a mirror
  matrix->SetElement(0, 3, 20.0);
  matrix->SetElement(1, 1, 0.75);
  const Mesh moved = makeAll();
  for (vtkIdType k = 0; k < moved->GetNumberOfPoints(); ++k)
  {
    const double* const p = moved->GetPoint(k);
    moved->GetPoints()->SetPoint(k, 20.0 - 0.5 * p[0], 0.75 * p[1], p[2]);
  }
  for (const int representation : { VTK_SURFACE, VTK_WIREFRAME, VTK_POINTS })
  {
    Board board, expected;
    board.property->SetRepresentation(representation);
    expected.property->SetRepresentation(representation);
    board.tracer->SetInputData(makeAll());
    board.tracer->SetInputTransform(0, matrix);
    expected.tracer->SetInputData(moved);
    EXPECT_SAME_BITS(render(board.tracer), render(expected.tracer));
    for (int cell = 0; cell < 6; ++cell)
    {
      EXPECT_EQ(board.count(cell), expected.count(cell)) << cell;
    }
  }
}

// Cells are counted in their blocks; blocks have colours of their own.
TEST(LineInputs, OfBlocks)
{
  Board board;
  vtkNew<vtkMultiBlockDataSet> blocks;
  const Mesh first = makeMesh({ { 2.5, 2.5, 0.0 }, { 9.5, 2.5, 0.0 } }, {});
  const Mesh second = makeMesh({ { 2.5, 9.5, 0.0 }, { 9.5, 9.5, 0.0 } }, {});
  first->SetLines(makeCells({ { 0, 1 } }));
  second->SetVerts(makeCells({ { 0 } }));
  second->SetLines(makeCells({ { 0, 1 } }));
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, second);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  const double color[3] = { 0.125, 0.25, 0.5 };
  attributes->SetBlockColor(second, color);
  board.tracer->SetInputDataObject(blocks);
  board.tracer->SetInputBlockAttributes(0, attributes);
  EXPECT_EQ(board.id(5, 2), 0);
  EXPECT_EQ(board.at("BlockIds", 5, 2), 1.0);
  EXPECT_EQ(board.id(2, 9), 0);
  EXPECT_EQ(board.id(5, 9), 1);
  EXPECT_EQ(board.at("BlockIds", 5, 9), 2.0);
  EXPECT_EQ(render(board.tracer).at(5, 9), Vec(0.125, 0.25, 0.5));
}

TEST(LineInputs, UseThePointNormalsOfTheInput)
{
  Board board;
  board.property->LightingOn();
  board.tracer->GenerateNormalsOn();
  const Mesh mesh = makeMesh({ { 2.5, 2.5, 0.0 }, { 10.5, 2.5, 0.0 } }, {});
  mesh->SetLines(makeCells({ { 0, 1 } }));
  setPointNormals(mesh, { { 0.6, 0.0, 0.8 }, { 0.6, 0.0, 0.8 } });
  board.tracer->SetInputData(mesh);
  const auto normal = [&](int k)
  {
    vtkDataArray* const normals = board.array("Normals");
    return normals->GetComponent(32 * 2 + 6, k);
  };
  EXPECT_NEAR(normal(0), 0.6, 1e-6);
  board.property->SetInterpolationToFlat();
  EXPECT_NEAR(normal(0), 0.0, 1e-6);
  EXPECT_NEAR(normal(2), 1.0, 1e-6);
  board.property->SetInterpolationToPhong();
  board.tracer->UsePointNormalsOff();
  EXPECT_NEAR(normal(0), 0.0, 1e-6);
  board.tracer->UsePointNormalsOn();
  board.property->RenderLinesAsTubesOn(); // have normals of their own
  EXPECT_NEAR(normal(0), 0.0, 1e-6);
}

TEST(LineInputs, AsTubesAreRound)
{
  Board board;
  board.property->LightingOn();
  board.property->SetLineWidth(7.0);
  const Mesh mesh = makeMesh({ { 2.5, 12.5, 0.0 }, { 28.5, 12.5, 0.0 } }, {});
  mesh->SetLines(makeCells({ { 0, 1 } }));
  board.tracer->SetInputData(mesh);
  const Picture flat = render(board.tracer);
  board.property->RenderLinesAsTubesOn();
  const Picture round = render(board.tracer);
  for (int k = -3; k <= 3; ++k)
  {
    EXPECT_EQ(flat.at(16, 12 + k), Vec(1.0)) << k;
    const double across = k / 3.5;
    expectColor(
      round.at(16, 12 + k), Vec(std::sqrt(1.0 - across * across)), std::to_string(k), 1e-5);
  }
}

TEST(LineInputs, AreNotCulled)
{
  for (const int representation : { VTK_WIREFRAME, VTK_POINTS })
  {
    Board board;
    board.property->SetRepresentation(representation);
    board.tracer->SetInputData(makeAll());
    const Picture expected = render(board.tracer);
    board.property->BackfaceCullingOn();
    board.property->FrontfaceCullingOn();
    EXPECT_SAME_BITS(render(board.tracer), expected);
  }
}

TEST(LineInputs, AreReplacedBySpheres)
{
  Board board;
  board.property->SetRepresentationToWireframe();
  board.tracer->SetInputData(makeAll());
  board.tracer->SetInputSphereRadius(0, 0.75);
  EXPECT_EQ(board.id(30, 22), 17); // the number of the point
  EXPECT_EQ(board.id(6, 20), -1);
}

// The default camera shows lines, too.
TEST(LineInputs, AreFramed)
{
  vtkNew<vtkLambentRayTracer> tracer;
  tracer->SetImageSize(50, 50);
  const Mesh mesh = makeMesh({ { 100.0, 2.0, 3.0 }, { 104.0, 5.0, 3.0 } }, {});
  mesh->SetLines(makeCells({ { 0, 1 } }));
  tracer->SetInputData(mesh);
  EXPECT_GT(50 * 50 - render(tracer).count(Vec(0.0)), 30);
  tracer->ResetCamera();
  ASSERT_NE(tracer->GetCamera(), nullptr);
  EXPECT_NEAR(tracer->GetCamera()->GetFocalPoint()[0], 102.0, 1e-12);
  EXPECT_NEAR(tracer->GetCamera()->GetFocalPoint()[1], 3.5, 1e-12);
}
