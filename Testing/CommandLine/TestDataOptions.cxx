// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The options that show data, and those of the property: what they parse, and what they set.

#include "DataScene.h"
#include "InputArrays.h"
#include "ListFile.h"

#include "vtkBitArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkProperty.h"

using namespace lambent::command;

TEST(DataOptions, RangesAreFiniteAndUpright)
{
  EXPECT_EQ(ParseRange("-1.5,1e3"), (std::array<double, 2>{ -1.5, 1000 }));
  EXPECT_EQ(ParseRange("2,2"), (std::array<double, 2>{ 2, 2 }));
  for (const char* text : { "", "1", "1,2,3", "1,", ",1", "nan,1", "0,inf", "1 2", "2,1" })
  {
    EXPECT_THROW(ParseRange(text), BadValue) << text;
  }
}

TEST(DataOptions, SpheresAreARadiusOrAnArrayOrBoth)
{
  EXPECT_EQ(ParseSpheres("0.5").radius, 0.5);
  EXPECT_EQ(ParseSpheres("0.5").array, "");
  EXPECT_EQ(ParseSpheres("size").radius, 1);
  EXPECT_EQ(ParseSpheres("a,b").array, "a,b");
  EXPECT_EQ(ParseSpheres("2,a,b").radius, 2);
  EXPECT_EQ(ParseSpheres("2,a,b").array, "a,b");
  for (const char* text : { "", "0", "-1", "2,", "-1,a", "0,a" })
  {
    EXPECT_THROW(ParseSpheres(text), BadValue) << text;
  }
}

TEST(DataOptions, TheProperty)
{
  const auto tracer = Scene({ "--specular", "0.25", "--specular-power", "40", "--opacity", "0.5",
    "--representation", "wireframe", "--edges", "--edge-color", "#ff0000", "--line-width", "2.5",
    "--point-size", "7" });
  vtkProperty* const property = tracer->GetProperty();
  EXPECT_EQ(property->GetSpecular(), 0.25);
  EXPECT_EQ(property->GetSpecularPower(), 40);
  EXPECT_EQ(property->GetOpacity(), 0.5);
  EXPECT_EQ(property->GetRepresentation(), VTK_WIREFRAME);
  EXPECT_TRUE(property->GetEdgeVisibility());
  EXPECT_EQ(property->GetEdgeColor()[0], 1);
  EXPECT_EQ(property->GetLineWidth(), 2.5f);
  EXPECT_EQ(property->GetPointSize(), 7.0f);
  EXPECT_EQ(
    Scene({ "--representation", "points" })->GetProperty()->GetRepresentation(), VTK_POINTS);
  EXPECT_TRUE(Scene({ "--edge-color", "red" })->GetProperty()->GetEdgeVisibility());
}

TEST(DataOptions, ThePropertyIsVtksByDefault)
{
  vtkProperty* const property = Scene({})->GetProperty();
  vtkNew<vtkProperty> usual;
  EXPECT_EQ(property->GetSpecular(), usual->GetSpecular());
  EXPECT_EQ(property->GetSpecularPower(), usual->GetSpecularPower());
  EXPECT_EQ(property->GetOpacity(), 1);
  EXPECT_EQ(property->GetRepresentation(), VTK_SURFACE);
  EXPECT_FALSE(property->GetEdgeVisibility());
  EXPECT_EQ(property->GetEdgeColor()[0], usual->GetEdgeColor()[0]);
  EXPECT_EQ(property->GetLineWidth(), usual->GetLineWidth());
  EXPECT_EQ(property->GetPointSize(), usual->GetPointSize());
}

TEST(DataOptions, Spheres)
{
  EXPECT_EQ(Scene({ "--spheres", "0.5" })->GetInputSphereRadius(0), 0.5);
  const auto tracer = Scene({ "--spheres", "2,t" }, { Colored(), Triangle() });
  EXPECT_EQ(tracer->GetInputSphereRadius(0), 2);
  EXPECT_STREQ(tracer->GetInputSphereRadiusArray(0), "t");
  EXPECT_EQ(tracer->GetInputSphereRadius(1), 0); // it has no such array
  EXPECT_EQ(Refusal({ "--spheres", "T" }),
    "--spheres T: no input has such a point array; write a radius or one of: point:t, point:m, "
    "point:v, point:rgb");
  EXPECT_NE(Refusal({ "--spheres", "v" }).find("has 3 components"), std::string::npos);
  auto mesh = Triangle();
  mesh->GetPointData()->AddArray(Numbers<vtkDoubleArray>("r", 1, { 1, -0.5, 2 }));
  EXPECT_NE(
    Refusal({ "--spheres", "r" }, { mesh }).find("point 1 has the value -0.5"), std::string::npos);
}

TEST(InputArrays, EditDistance)
{
  EXPECT_EQ(EditDistance("", ""), 0u);
  EXPECT_EQ(EditDistance("", "abc"), 3u);
  EXPECT_EQ(EditDistance("abc", ""), 3u);
  EXPECT_EQ(EditDistance("kitten", "Sitting"), 3u);
  EXPECT_EQ(EditDistance("temprature", "Temperature"), 1u);
  EXPECT_EQ(EditDistance("abcd", "bcda"), 2u);
}

TEST(ListData, BlocksAndArrays)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Colored());
  const auto second = Triangle();
  second->GetPointData()->AddArray(Numbers<vtkDoubleArray>("t", 1, { -1, 2, std::nan("") }));
  vtkNew<vtkBitArray> bits;
  bits->SetName("a flag");
  bits->InsertNextValue(1);
  second->GetCellData()->AddArray(bits);
  blocks->SetBlock(3, second);
  blocks->GetMetaData(3u)->Set(vtkCompositeDataSet::NAME(), "the lid");
  EXPECT_EQ(ListData("a.vtm", blocks),
    "a.vtm: 6 points, 2 cells, 2 blocks\n"
    "x 0 to 1, y 0 to 1, z 0 to 0\n"
    "\n"
    "points  cells  kind      block\n"
    "3       1      polygons  0\n"
    "3       1      polygons  1 the lid\n"
    "\n"
    "of     type     components  low  high  blocks  array\n"
    "point  float64  1           -1   8     2       t\n"
    "point  float32  3           0    5     1       v\n"
    "point  uint8    3           -    -     1       rgb\n"
    "point  uint8    1           0    3     1       m\n"
    "cell   float64  1           5    5     1       t\n"
    "cell   float64  1           -5   -5    1       c\n"
    "cell   text     1           -    -     1       text\n"
    "cell   bit      1           1    1     1       a flag\n");
  EXPECT_EQ(ListData("b.vtp", Triangle()),
    "b.vtp: 3 points, 1 cell, 1 block\n"
    "x 0 to 1, y 0 to 1, z 0 to 0\n"
    "\n"
    "points  cells  kind      block\n"
    "3       1      polygons  0\n"
    "\n"
    "no arrays\n");
}
