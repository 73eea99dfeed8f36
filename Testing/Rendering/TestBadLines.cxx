// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Unusable widths and cells of lines cause an error that names the connection and the remedy.
#include "ExpectedErrors.h"

#include <limits>

namespace
{
const double notANumber = std::numeric_limits<double>::quiet_NaN();

void expectCellError(const Mesh& mesh, const std::vector<std::string>& parts)
{
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->AddInputDataObject(makeSquare());
  studio.tracer->AddInputDataObject(mesh);
  studio.tracer->Update();
  expectMessage(messages.errors(), parts);
  EXPECT_EQ(studio.tracer->GetOutput()->GetNumberOfPoints(), 0);
}
}

TEST(BadLines, Widths)
{
  for (const double width : { 0.0, notANumber })
  {
    const std::string number = width == 0.0 ? "0" : "nan";
    expectError(
      [&](Studio& s)
      {
        s.property->SetRepresentationToWireframe();
        s.property->SetLineWidth(static_cast<float>(width));
      },
      { "Input 0", "the width of lines is " + number, "finite number of pixels above 0",
        "SetLineWidth()" },
      [](Studio& s)
      {
        s.property->SetRepresentationToSurface();
        s.property->SetLineWidth(1.0f);
      });
    expectError(
      [&](Studio& s)
      {
        s.property->SetRepresentationToPoints();
        s.property->SetPointSize(static_cast<float>(width));
      },
      { "Input 0", "the size of points is " + number, "SetPointSize()" },
      [](Studio& s)
      {
        s.property->SetRepresentationToSurface();
        s.property->SetPointSize(1.0f);
      });
  }
}

// Nothing is wrong with a width that nothing has.
TEST(BadLines, UnusedWidths)
{
  Studio studio;
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(makeSphere(6));
  const Picture expected = render(studio.tracer);
  studio.property->SetLineWidth(0.0f);
  studio.property->SetPointSize(0.0f);
  studio.property->SetVertexColor(notANumber, 0.0, 0.0);
  EXPECT_SAME_BITS(render(studio.tracer), expected);
  EXPECT_TRUE(messages.errors().empty());
  EXPECT_TRUE(messages.warnings().empty());
}

TEST(BadLines, HugeWidthsFillThePicture)
{
  Studio studio;
  const Messages messages(studio.tracer);
  const Mesh mesh = makeMesh({ { 0.0, 0.0, 0.0 } }, {});
  mesh->SetVerts(makeCells({ { 0 } }));
  studio.property->SetPointSize(std::numeric_limits<float>::max());
  studio.tracer->SetInputData(mesh);
  EXPECT_EQ(render(studio.tracer).count(Studio::background()), 0);
  EXPECT_TRUE(messages.errors().empty());
}

TEST(BadLines, VertexColour)
{
  expectError(
    [](Studio& s)
    {
      s.property->VertexVisibilityOn();
      s.property->SetVertexColor(0.0, notANumber, 0.0);
    },
    { "Input 0", "colour of vertices", "not a finite number", "SetVertexColor()" },
    [](Studio& s)
    {
      s.property->VertexVisibilityOff();
      s.property->SetVertexColor(0.5, 1.0, 0.5);
    });
}

TEST(BadLines, MissingPoints)
{
  for (const vtkIdType wrong : { vtkIdType(4), vtkIdType(-1), VTK_ID_MAX })
  {
    const std::string point = "uses point " + std::to_string(wrong);
    Mesh mesh = makeSquare();
    mesh->SetVerts(makeCells({ { 0 }, { 1, wrong } }));
    mesh->SetLines(makeCells({ { 0, 1 } }));
    expectCellError(mesh, { "Input 1", "cell 1 ", point, "4 points", "Correct the connectivity" });
    mesh->SetVerts(makeCells({ { 0 } }));
    mesh->SetLines(makeCells({ { 0, 1 }, { 0, wrong } }));
    expectCellError(mesh, { "Input 1", "cell 2 ", point, "4 points" });
  }
  for (const int representation : { VTK_WIREFRAME, VTK_POINTS })
  {
    Studio studio;
    const Messages messages(studio.tracer);
    studio.property->SetRepresentation(representation);
    studio.tracer->SetInputData(makeMesh({ { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 1, 7 } }));
    studio.tracer->Update();
    expectMessage(messages.errors(), { "Input 0", "cell 0 ", "uses point 7" });
  }
}

TEST(BadLines, NonFiniteCoordinates)
{
  Studio studio;
  const Messages messages(studio.tracer);
  const Mesh mesh = makeMesh(
    { { -1.0, 0.0, 0.0 }, { notANumber, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 } }, {});
  mesh->SetVerts(makeCells({ { 0 } }));
  mesh->SetLines(makeCells({ { 0, 1, 2 }, { 2, 3 } }));
  studio.tracer->SetInputData(mesh);
  EXPECT_LT(render(studio.tracer).count(Studio::background()), 32 * 24 - 3);
  expectMessage(messages.warnings(),
    { "1 cell has a point that is not finite", "the first is cell 1 of input 0", "Remove" });
}
