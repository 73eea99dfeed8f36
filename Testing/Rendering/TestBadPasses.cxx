// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Invalid pass arrays and background images cause an error that names them and the remedy, and an
// empty output. The next valid picture is right.
#include "ExpectedErrors.h"

#include "vtkStringArray.h"

namespace
{
constexpr int points = vtkDataObject::FIELD_ASSOCIATION_POINTS;
constexpr int cells = vtkDataObject::FIELD_ASSOCIATION_CELLS;

void removePassArrays(Studio& studio)
{
  studio.tracer->RemoveAllPassArrays();
}

/// An array of zeros.
vtkSmartPointer<vtkDataArray> zeros(const char* name, vtkIdType tuples, int components)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  array->Fill(0.0);
  return array;
}

Mesh makeSquareWith(const char* name, vtkIdType tuples, int components, bool isOfCells)
{
  const Mesh square = makeSquare(0.5);
  isOfCells ? square->GetCellData()->AddArray(zeros(name, tuples, components))
            : square->GetPointData()->AddArray(zeros(name, tuples, components));
  return square;
}

/// Expects an error with a second input.
void expectErrorOf(
  const Mesh& mesh, int association, const char* name, const std::vector<std::string>& parts)
{
  expectError(
    [&](Studio& s)
    {
      s.tracer->AddInputDataObject(mesh);
      s.tracer->AddPassArray(association, name);
    },
    parts,
    [](Studio& s)
    {
      s.tracer->RemoveInputConnection(0, 1);
      removePassArrays(s);
    });
}

void expectErrorOfImage(vtkImageData* image, const std::vector<std::string>& parts)
{
  expectError([&](Studio& s) { s.tracer->SetBackgroundImage(image); }, parts,
    [](Studio& s) { s.tracer->SetBackgroundImage(nullptr); });
}

vtkSmartPointer<vtkImageData> makeImage(int depth, int components, int type)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(4, 3, depth);
  image->AllocateScalars(type, components);
  image->GetPointData()->GetScalars()->Fill(0.0);
  return image;
}
}

// This also holds if the picture does not have that array now, or if no input has one of that name.
TEST(BadPasses, RefusesNamesOfThePicturesOwnArrays)
{
  for (const char* name :
    { "Color", "Depth", "Normals", "Positions", "CellIds", "InputIds", "BlockIds" })
  {
    for (const int association : { points, cells })
    {
      const std::string kind = association == points ? "point array" : "cell array";
      expectError([&](Studio& s) { s.tracer->AddPassArray(association, name); },
        { "AddPassArray()", kind + " \"" + name + "\"", "another array of that name",
          "RemoveAllPassArrays()" },
        removePassArrays);
    }
  }
}

TEST(BadPasses, RefusesTheSameNameTwice)
{
  for (const int second : { points, cells })
  {
    expectError(
      [&](Studio& s)
      {
        s.tracer->AddInputDataObject(makeSquareWith("Heat", 4, 1, false));
        s.tracer->AddPassArray(points, "Heat");
        s.tracer->AddPassArray(second, "Heat");
      },
      { "AddPassArray()", std::string(second == points ? "point" : "cell") + " array \"Heat\"",
        "another array of that name", "RemoveAllPassArrays()" },
      [](Studio& s)
      {
        s.tracer->RemoveInputConnection(0, 1);
        removePassArrays(s);
      });
  }
}

TEST(BadPasses, RefusesUnknownAssociations)
{
  for (const int association : { -1, static_cast<int>(vtkDataObject::FIELD_ASSOCIATION_NONE),
         static_cast<int>(vtkDataObject::FIELD_ASSOCIATION_ROWS), 99 })
  {
    expectError([&](Studio& s) { s.tracer->AddPassArray(association, "Heat"); },
      { "AddPassArray()", "association " + std::to_string(association), "\"Heat\"",
        "FIELD_ASSOCIATION_POINTS (0)", "FIELD_ASSOCIATION_CELLS (1)", "RemoveAllPassArrays()" },
      removePassArrays);
  }
}

// An empty name is refused at once, and nothing is added.
TEST(BadPasses, RefusesAnEmptyName)
{
  for (const char* name : { static_cast<const char*>(nullptr), "" })
  {
    Studio studio;
    Messages messages(studio.tracer);
    studio.tracer->SetInputData(makeSquare());
    studio.tracer->Update();
    const vtkMTimeType time = studio.tracer->GetMTime();
    studio.tracer->AddPassArray(points, name);
    expectMessage(messages.errors(), { "AddPassArray()", "no name" });
    EXPECT_EQ(studio.tracer->GetMTime(), time);
    studio.tracer->Update();
    EXPECT_EQ(studio.tracer->GetOutput()->GetPointData()->GetNumberOfArrays(), 1);
    EXPECT_EQ(messages.errors().size(), 1u);
    EXPECT_TRUE(messages.warnings().empty());
  }
}

TEST(BadPasses, RefusesArraysOfTheWrongLength)
{
  for (const vtkIdType tuples : { 0, 3, 5 })
  {
    expectErrorOf(makeSquareWith("Heat", tuples, 2, false), points, "Heat",
      { "Input 1:", "point array \"Heat\"", std::to_string(tuples) + " tuples of 2", "4 points",
        "RemoveAllPassArrays()" });
  }
  expectErrorOf(makeSquareWith("Part", 2, 1, true), cells, "Part",
    { "Input 1:", "cell array \"Part\"", "2 tuples of 1", "1 cells", "RemoveAllPassArrays()" });
}

TEST(BadPasses, RefusesInputsThatDifferInComponents)
{
  expectError(
    [&](Studio& s)
    {
      s.tracer->AddInputDataObject(makeSquareWith("Heat", 4, 3, false));
      s.tracer->AddInputDataObject(makeSquare(0.25)); // without it
      s.tracer->AddInputDataObject(makeSquareWith("Heat", 4, 2, false));
      s.tracer->AddPassArray(points, "Heat");
    },
    { "Input 3:", "point array \"Heat\"", "2 components", "that of input 1 has 3", "rename" },
    [](Studio& s)
    {
      s.tracer->RemoveInputConnection(0, 3);
      s.tracer->RemoveInputConnection(0, 2);
      s.tracer->RemoveInputConnection(0, 1);
      removePassArrays(s);
    });
}

TEST(BadPasses, WarnsOfArraysThatNoInputHas)
{
  Studio studio(4, 3);
  Messages messages(studio.tracer);
  const Mesh square = makeSquareWith("Heat", 4, 1, false);
  square->GetPointData()->AddArray(zeros("Flow", 4, 3));
  vtkNew<vtkStringArray> words; // a pass cannot show strings
  words->SetName("Words");
  words->SetNumberOfValues(4);
  square->GetPointData()->AddArray(words);
  studio.tracer->AddInputDataObject(square);
  studio.tracer->AddPassArray(points, "heat");
  studio.tracer->Update();
  expectMessage(messages.warnings(),
    { "AddPassArray()", "point array \"heat\"", "no input has", "NaN", "\"Flow\", \"Heat\"." });
  EXPECT_EQ(messages.warnings()[0].find("Words"), std::string::npos);
  vtkDataArray* const pass = studio.tracer->GetOutput()->GetPointData()->GetArray("heat");
  ASSERT_NE(pass, nullptr);
  EXPECT_EQ(pass->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(pass->GetNumberOfComponents(), 1);
  for (vtkIdType pixel = 0; pixel < 12; ++pixel)
  {
    EXPECT_TRUE(std::isnan(pass->GetComponent(pixel, 0)));
  }
  studio.camera->Azimuth(1.0);
  studio.tracer->Update(); // not once per picture
  EXPECT_EQ(messages.warnings().size(), 1u);
  messages.clear();
  studio.tracer->RemoveAllPassArrays();
  studio.tracer->AddPassArray(cells, "Heat"); // a point array
  studio.tracer->Update();
  expectMessage(messages.warnings(), { "cell array \"Heat\"", "The inputs have none." });
  messages.clear();
  studio.tracer->RemoveAllPassArrays();
  studio.tracer->AddPassArray(points, "Heat"); // the remedy
  studio.tracer->Update();
  EXPECT_TRUE(messages.warnings().empty());
  EXPECT_TRUE(messages.errors().empty());
}

TEST(BadPasses, RefusesBackgroundImagesWithoutScalars)
{
  vtkNew<vtkImageData> empty, bare, none;
  bare->SetDimensions(4, 3, 1);
  none->SetDimensions(4, 3, 1);
  none->GetPointData()->SetScalars(zeros("Color", 0, 3));
  for (vtkImageData* image : { empty.Get(), bare.Get(), none.Get() })
  {
    expectErrorOfImage(image, { "SetBackgroundImage()", "without scalars", "Update" });
  }
}

TEST(BadPasses, RefusesBackgroundImagesOfOtherTypes)
{
  for (const auto& [type, name] : { std::make_pair(VTK_DOUBLE, "double"),
         std::make_pair(VTK_SHORT, "short"), std::make_pair(VTK_UNSIGNED_SHORT, "unsigned short"),
         std::make_pair(VTK_SIGNED_CHAR, "signed char") })
  {
    expectErrorOfImage(makeImage(1, 3, type),
      { "SetBackgroundImage()", std::string("of type ") + name, "unsigned char and float",
        "vtkImageShiftScale" });
  }
}

TEST(BadPasses, RefusesBackgroundImagesWithTooManyComponents)
{
  for (const int components : { 5, 9 })
  {
    expectErrorOfImage(makeImage(1, components, VTK_UNSIGNED_CHAR),
      { "SetBackgroundImage()", "of " + std::to_string(components) + " components", "1 to 4",
        "vtkImageExtractComponents" });
  }
}

TEST(BadPasses, RefusesBackgroundImagesWithSeveralSlices)
{
  expectErrorOfImage(makeImage(2, 3, VTK_UNSIGNED_CHAR),
    { "SetBackgroundImage()", "of 2 slices", "it takes one", "vtkExtractVOI" });
}

TEST(BadPasses, RefusesBackgroundImagesOfTheWrongLength)
{
  const auto image = makeImage(1, 3, VTK_FLOAT);
  image->GetPointData()->SetScalars(zeros("Color", 11, 3));
  expectErrorOfImage(image, { "SetBackgroundImage()", "of 12 pixels", "have 11 tuples", "extent" });
}
