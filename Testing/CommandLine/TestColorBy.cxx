// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours from arrays: --color-by, and those of the files.

#include "DataScene.h"

#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkProperty.h"

#include <cmath>

using namespace lambent::command;

TEST(ColorBy, SettingsOfNumbers)
{
  const auto tracer =
    Scene({ "--color-by", "t", "--colormap", "gray_r", "--log", "--nan-color", "lime" });
  EXPECT_TRUE(tracer->GetInputScalarVisibility(0));
  EXPECT_STREQ(tracer->GetInputColorArrayName(0), "t");
  EXPECT_EQ(tracer->GetInputColorArrayAssociation(0), vtkDataObject::FIELD_ASSOCIATION_POINTS);
  EXPECT_EQ(tracer->GetInputColorComponent(0), 0);
  EXPECT_TRUE(tracer->GetInputInterpolateScalarsBeforeMapping(0));
  double range[2];
  ASSERT_TRUE(tracer->GetInputScalarRange(0, range));
  EXPECT_EQ(range[0], 2);
  EXPECT_EQ(range[1], 8);
  auto* const table = vtkLookupTable::SafeDownCast(tracer->GetInputLookupTable(0));
  ASSERT_TRUE(table);
  EXPECT_EQ(table->GetNumberOfTableValues(), 256);
  EXPECT_EQ(table->GetScale(), VTK_SCALE_LOG10);
  EXPECT_EQ(table->GetNanColor()[1], 1);
  table->Build();
  for (int k = 0; k < 256; ++k)
  {
    EXPECT_EQ(table->GetPointer(k)[1], 255 - k); // the bytes of the map, exactly
  }
}

TEST(ColorBy, AssociationsAndComponents)
{
  struct
  {
    const char* text;
    const char* name;
    int association, component;
  } const cases[] = { { "t", "t", 0, 0 }, { "point:t", "t", 0, 0 }, { "cell:t", "t", 1, 0 },
    { "c", "c", 1, 0 }, { "v", "v", 0, -1 }, { "v:magnitude", "v", 0, -1 }, { "v:2", "v", 0, 2 },
    { "point:v:1", "v", 0, 1 }, { "m", "m as numbers", 0, 0 }, { "rgb:1", "rgb as numbers", 0, 1 },
    { "rgb:magnitude", "rgb as numbers", 0, -1 } };
  for (const auto& expected : cases)
  {
    const auto tracer = Scene({ "--color-by", expected.text });
    EXPECT_STREQ(tracer->GetInputColorArrayName(0), expected.name) << expected.text;
    EXPECT_EQ(tracer->GetInputColorArrayAssociation(0), expected.association) << expected.text;
    EXPECT_EQ(tracer->GetInputColorComponent(0), expected.component) << expected.text;
    EXPECT_TRUE(tracer->GetInputLookupTable(0)) << expected.text;
  }
  const auto colors = Scene({ "--color-by", "rgb" });
  EXPECT_STREQ(colors->GetInputColorArrayName(0), "rgb");
  EXPECT_FALSE(colors->GetInputLookupTable(0));
}

TEST(ColorBy, NamesMayHaveColons)
{
  const auto mesh = Colored();
  mesh->GetPointData()->AddArray(Numbers<vtkDoubleArray>("v:0", 1, { 1, 2, 3 }));
  mesh->GetPointData()->AddArray(Numbers<vtkDoubleArray>("cell:x", 1, { 1, 2, 3 }));
  EXPECT_STREQ(Scene({ "--color-by", "v:0" }, { mesh })->GetInputColorArrayName(0), "v:0");
  EXPECT_STREQ(Scene({ "--color-by", "v:0:0" }, { mesh })->GetInputColorArrayName(0), "v:0");
  EXPECT_STREQ(Scene({ "--color-by", "cell:x" }, { mesh })->GetInputColorArrayName(0), "cell:x");
}

TEST(ColorBy, AllInputsShareOneRange)
{
  const auto low = Triangle(), high = Triangle(), other = Triangle();
  low->GetPointData()->AddArray(Numbers<vtkDoubleArray>("t", 1, { -1, std::nan(""), 2 }));
  high->GetCellData()->AddArray(Numbers<vtkFloatArray>("t", 1, { 9 }));
  const auto tracer = Scene({ "--color-by", "t", "--color", "red" }, { low, other, high, low });
  double range[2];
  ASSERT_TRUE(tracer->GetInputScalarRange(0, range));
  EXPECT_EQ(range[0], -1);
  EXPECT_EQ(range[1], 9);
  EXPECT_EQ(tracer->GetInputLookupTable(0), tracer->GetInputLookupTable(2));
  EXPECT_EQ(tracer->GetInputColorArrayAssociation(2), vtkDataObject::FIELD_ASSOCIATION_CELLS);
  EXPECT_FALSE(tracer->GetInputScalarVisibility(1));
  EXPECT_EQ(tracer->GetProperty()->GetDiffuseColor()[1], 0);
}

TEST(ColorBy, TheMagnitudeOfOneNumberIsNotNegative)
{
  const auto tracer = Scene({ "--color-by", "c:magnitude" });
  double range[2];
  ASSERT_TRUE(tracer->GetInputScalarRange(0, range));
  EXPECT_EQ(range[0], 0);
  EXPECT_EQ(range[1], 5);
}

TEST(ColorBy, WrongNamesListTheArraysNearestFirst)
{
  EXPECT_EQ(Refusal({ "--color-by", "RGBA" }),
    "--color-by RGBA: no input has such an array; the arrays of numbers are: point:rgb, point:m, "
    "point:t, point:v, cell:c, cell:t");
  EXPECT_EQ(
    Refusal({ "--color-by", "text" }).find("--color-by text: it is an array of text; "), 0u);
  EXPECT_EQ(Refusal({ "--color-by", "cell:v" }).find("--color-by cell:v: no input has"), 0u);
  EXPECT_EQ(Refusal({ "--color-by", "a" }, { Triangle() }),
    "--color-by a: no input has such an array; the arrays of numbers are: none");
}

TEST(ColorBy, WrongComponentsNameTheRightOnes)
{
  for (const char* text : { "v:3", "v:-1", "v:x", "v:", "v:99999999999" })
  {
    EXPECT_EQ(Refusal({ "--color-by", text }),
      "--color-by " + std::string(text) +
        ": the array has 3 components, counted from 0; write v, v:0 to v:2 or v:magnitude");
  }
  EXPECT_EQ(Refusal({ "--color-by", "t:1" }), "--color-by t:1: the array has 1 component; write t");
}

TEST(ColorBy, LogarithmsNeedNumbersAboveZero)
{
  EXPECT_EQ(Refusal({ "--color-by", "c", "--log" }),
    "--log: c goes from -5 to -5, but a logarithm needs numbers above 0; omit --log");
  EXPECT_EQ(Refusal({ "--color-by", "v", "--log" }),
    "--log: v goes from 0 to 5, but a logarithm needs numbers above 0; set --range, such as "
    "--range 1,5, or omit --log");
  EXPECT_EQ(Refusal({ "--color-by", "c", "--log", "--range", "1,2" }), "");
  EXPECT_EQ(Parse({ "--color-by", "c", "--log", "--range", "0,2" }).exitStatus, 2);
}

TEST(ColorBy, ArraysWithoutFiniteNumbersHaveARange)
{
  const auto mesh = Triangle();
  const double nan = std::nan("");
  mesh->GetPointData()->AddArray(Numbers<vtkDoubleArray>("t", 1, { nan, nan, nan }));
  for (const bool isLogarithmic : { false, true })
  {
    auto arguments = std::vector<const char*>{ "--color-by", "t" };
    arguments.resize(isLogarithmic ? 3 : 2, "--log");
    const auto tracer = Scene(arguments, { mesh });
    tracer->Update();
    EXPECT_EQ(tracer->GetOutput()->GetNumberOfPoints(), 64);
  }
}

TEST(ColorBy, RoundingErrorsOfAConstantAreOneColor)
{
  const auto mesh = Triangle();
  mesh->GetPointData()->AddArray(Numbers<vtkFloatArray>("t", 1, { 0.3, 0.3f + 3e-8f, 0.3 }));
  double range[2];
  ASSERT_TRUE(Scene({ "--color-by", "t" }, { mesh })->GetInputScalarRange(0, range));
  EXPECT_EQ(range[0], static_cast<double>(0.3f));
  EXPECT_GT(256 * (0.3f + 3e-8f - range[0]), 0);
  EXPECT_LT(256 * (0.3f + 3e-8f - range[0]), range[1] - range[0]); // the same entry
}

TEST(ColorBy, ATableInTheFileIsNotUsed)
{
  const auto mesh = Colored();
  vtkNew<vtkLookupTable> own;
  mesh->GetPointData()->GetArray("t")->SetLookupTable(own);
  Scene({ "--color-by", "t" }, { mesh });
  EXPECT_EQ(mesh->GetPointData()->GetArray("t")->GetLookupTable(), nullptr);
}

TEST(OwnColors, AreTheActiveBytesOfThreeOrFourComponents)
{
  const auto isColored =
    [](const char* ofPoints, const char* ofCells, std::vector<const char*> arguments = {})
  {
    const auto mesh = Colored();
    mesh->GetCellData()->AddArray(Numbers<vtkUnsignedCharArray>("rgba", 4, { 1, 2, 3, 4 }));
    mesh->GetPointData()->SetActiveScalars(ofPoints);
    mesh->GetCellData()->SetActiveScalars(ofCells);
    return Scene(arguments, { mesh })->GetInputScalarVisibility(0);
  };
  EXPECT_FALSE(isColored(nullptr, nullptr));
  EXPECT_TRUE(isColored("rgb", nullptr));
  EXPECT_TRUE(isColored(nullptr, "rgba"));
  EXPECT_FALSE(isColored("t", "rgba")); // the ray tracer would take t
  EXPECT_FALSE(isColored("m", nullptr));
  EXPECT_FALSE(isColored("rgb", nullptr, { "--color", "red" }));
  EXPECT_TRUE(isColored("rgb", nullptr, { "--color", "file" }));
}
