// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Edges of cells as the settings of vtkProperty describe them. Testing/Core has the formulas.
#include "ExpectedErrors.h"
#include "Meshes.h"

#include "EdgesFromVTK.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkMatrix4x4.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

namespace
{
const Vec black(0.0), white(1.0);

/// A view of 40 x 40 pixels, one unit each, with the origin between four of them; surfaces are
/// white and unlit.
struct Sheet : Studio
{
  Sheet()
    : Studio(40, 40)
  {
    this->camera->ParallelProjectionOn();
    this->camera->SetParallelScale(20.0);
    this->property->LightingOff();
    this->property->EdgeVisibilityOn();
    this->property->SetLineWidth(2.0f);
  }
};

/// Two quads that share the edge x = 0, from -10 to 10.
Mesh makeQuads()
{
  return makeMesh(
    { { -10, -10, 0 }, { 0, -10, 0 }, { 10, -10, 0 }, { 10, 10, 0 }, { 0, 10, 0 }, { -10, 10, 0 } },
    { { 0, 1, 4, 5 }, { 1, 2, 3, 4 } });
}

/// The properties of a newer VTK.
struct NewerProperty
{
  double color[3] = { 0.25, 0.5, 0.75 };
  bool usesLineWidth = true;

  double* GetEdgeColor() { return this->color; }
  double GetEdgeOpacity() const { return 0.375; }
  float GetLineWidth() const { return 3.0f; }
  float GetEdgeWidth() const { return 5.0f; }
  bool GetUseLineWidthForEdgeThickness() const { return this->usesLineWidth; }
  int GetEdgeVisibility() const { return 1; }
  int GetRepresentation() const { return VTK_SURFACE; }
};
}

TEST(Edges, OfPolygonsAreDrawnWithoutDiagonals)
{
  Sheet sheet;
  sheet.tracer->SetInputData(makeQuads());
  const Picture picture = render(sheet.tracer);
  for (int j = 0; j < 40; ++j)
  {
    for (int i = 0; i < 40; ++i)
    {
      const bool isInside = i >= 10 && i < 30 && j >= 10 && j < 30;
      const bool isEdge = i == 10 || i == 29 || j == 10 || j == 29 || i == 19 || i == 20;
      EXPECT_EQ(picture.at(i, j),
        !isInside  ? Studio::background()
          : isEdge ? black
                   : white)
        << pixelName(i, j);
    }
  }
}

TEST(Edges, OfTrianglesAreDrawnOnBothSides)
{
  Sheet sheet;
  sheet.tracer->SetInputData(
    makeMesh({ { -10, -10, 0 }, { 10, -10, 0 }, { 10, 10, 0 }, { -10, 10, 0 } },
      { { 0, 1, 2 }, { 0, 2, 3 } }));
  const Picture picture = render(sheet.tracer);
  for (int i = 11; i < 29; ++i)
  {
    EXPECT_EQ(picture.at(i, i), black) << i; // the diagonal
  }
  EXPECT_EQ(picture.at(15, 16), black); // at a distance of 0.71
  EXPECT_EQ(picture.at(16, 15), black);
  EXPECT_EQ(picture.at(15, 17), white); // 1.41
}

TEST(Edges, OfStripsAreThoseOfAllTheirTriangles)
{
  Sheet sheet;
  Mesh mesh = makeMesh({ { -10, -10, 0 }, { 10, -10, 0 }, { -10, 10, 0 }, { 10, 10, 0 } }, {});
  mesh->SetStrips(makeCells({ { 0, 1, 2, 3 } }));
  sheet.tracer->SetInputData(mesh);
  const Picture picture = render(sheet.tracer);
  EXPECT_EQ(picture.at(15, 24), black); // on the diagonal from (10, -10) to (-10, 10)
  EXPECT_EQ(picture.at(10, 20), black);
  EXPECT_EQ(picture.at(15, 20), white);
}

TEST(Edges, HaveTheirOwnColourAndWidth)
{
  Sheet sheet;
  sheet.property->SetEdgeColor(0.25, 0.5, 0.75);
  sheet.property->SetLineWidth(5.0f);
  sheet.tracer->SetInputData(makeQuads());
  const Picture picture = render(sheet.tracer);
  EXPECT_EQ(picture.at(10, 20), Vec(0.25, 0.5, 0.75));
  EXPECT_EQ(picture.at(12, 20), Vec(0.25, 0.5, 0.75)); // 2.5 from the edge
  EXPECT_EQ(picture.at(13, 20), white);
}

// They are not lit, whatever shading the faces have.
TEST(Edges, AreNotLit)
{
  for (const int interpolation : { VTK_FLAT, VTK_PHONG })
  {
    Sheet sheet;
    sheet.property->LightingOn();
    sheet.property->SetInterpolation(interpolation);
    sheet.property->SetEdgeColor(0.25, 0.5, 0.75);
    sheet.tracer->AddLight(makeLight({ 0.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 }));
    sheet.tracer->SetInputData(makeQuads());
    const Picture picture = render(sheet.tracer);
    EXPECT_EQ(picture.at(10, 20), Vec(0.25, 0.5, 0.75));
    expectColor(picture.at(15, 20), Vec(0.8), "face");
  }
}

TEST(Edges, AreOfFilledFacesOnly)
{
  Sheet sheet;
  sheet.tracer->SetInputData(makeQuads());
  for (const int representation : { VTK_WIREFRAME, VTK_POINTS })
  {
    sheet.property->SetRepresentation(representation);
    EXPECT_FALSE(lambent::adapters::edgesFromVTK(sheet.property.GetPointer()).areVisible);
  }
  sheet.property->SetRepresentationToSurface();
  EXPECT_TRUE(lambent::adapters::edgesFromVTK(sheet.property.GetPointer()).areVisible);
  sheet.property->EdgeVisibilityOff();
  EXPECT_EQ(render(sheet.tracer).count(white), 400);
}

TEST(Edges, LeavePassesAlone)
{
  Sheet sheet;
  sheet.tracer->SetInputData(makeQuads());
  sheet.tracer->GenerateDepthOn();
  sheet.tracer->GenerateNormalsOn();
  sheet.tracer->GenerateIdsOn();
  const auto passes = [&]()
  {
    sheet.tracer->Update();
    std::string all;
    for (const char* name : { "Depth", "Normals", "CellIds" })
    {
      vtkDataArray* const array = sheet.tracer->GetOutput()->GetPointData()->GetArray(name);
      all.append(static_cast<const char*>(array->GetVoidPointer(0)),
        static_cast<std::size_t>(array->GetDataSize()) * array->GetDataTypeSize());
    }
    return all;
  };
  const std::string with = passes();
  sheet.property->EdgeVisibilityOff();
  EXPECT_EQ(passes(), with);
}

// The diagonal of the first quad stays inside when its neighbour is not drawn, and the mesh is
// mirrored.
TEST(Edges, OfMirroredMeshesWithGhostsArePicked)
{
  Sheet sheet;
  Mesh mesh = makeQuads();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->InsertNextValue(vtkDataSetAttributes::HIDDENCELL);
  ghosts->InsertNextValue(0);
  mesh->GetCellData()->AddArray(ghosts);
  vtkNew<vtkMatrix4x4> mirror;
  mirror->SetElement(0, 0, -1.0);
  sheet.tracer->SetInputData(mesh);
  sheet.tracer->SetInputTransform(0, mirror);
  const Picture picture = render(sheet.tracer);
  for (int j = 10; j < 30; ++j)
  {
    for (int i = 10; i < 20; ++i)
    {
      const bool isEdge = i == 10 || i == 19 || j == 10 || j == 29;
      EXPECT_EQ(picture.at(i, j), isEdge ? black : white) << pixelName(i, j);
    }
  }
  EXPECT_EQ(picture.at(25, 20), Studio::background());
}

TEST(Edges, OfNewerVersionsHaveOpacityAndWidth)
{
  using lambent::adapters::edgesFromVTK;
  NewerProperty property;
  EXPECT_EQ(edgesFromVTK(&property).opacity, 0.375);
  EXPECT_EQ(edgesFromVTK(&property).color, Vec(0.25, 0.5, 0.75));
  EXPECT_EQ(edgesFromVTK(&property).width, 3.0);
  property.usesLineWidth = false;
  EXPECT_EQ(edgesFromVTK(&property).width, 5.0);
  EXPECT_EQ(edgesFromVTK(Sheet().property.GetPointer()).opacity, 1.0);
}

TEST(Edges, ThatAreNotFiniteAreAnError)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto mend = [](Studio& studio) { studio.property->EdgeVisibilityOff(); };
  const std::vector<std::string> parts{ "vtkProperty has an edge colour", "not a finite number",
    "SetEdgeColor()", "SetLineWidth()", "EdgeVisibilityOff()" };
  expectError(
    [&](Studio& studio)
    {
      studio.property->EdgeVisibilityOn();
      studio.property->SetEdgeColor(0.0, nan, 0.0);
    },
    parts, mend);
  expectError(
    [&](Studio& studio)
    {
      studio.property->EdgeVisibilityOn();
      studio.property->SetLineWidth(static_cast<float>(nan));
    },
    parts, mend);
}
