// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Colours from arrays: at points and in cells they are, to the byte, those of
// vtkScalarsToColors::MapScalars(). Between points, either colours or numbers are interpolated.
#include "ColoredGrid.h"

#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkIntArray.h"
#include "vtkLookupTable.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkShortArray.h"
#include "vtkUnsignedCharArray.h"

#include <array>

namespace
{
using Table = vtkSmartPointer<vtkScalarsToColors>;
using Array = vtkSmartPointer<vtkDataArray>;

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkLookupTable> lookupTable(int count, double low, double high)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(count);
  table->SetRange(low, high);
  table->SetHueRange(0.1, 0.8);
  table->SetValueRange(0.2, 1.0);
  return table;
}

std::vector<std::pair<std::string, Table>> tables()
{
  std::vector<std::pair<std::string, Table>> result;
  result.emplace_back("linear", lookupTable(256, -2.0, 3.0));
  result.emplace_back("of three colours", lookupTable(3, -1.0, 1.0));
  result.emplace_back("of an empty range", lookupTable(5, 1.0, 1.0));
  auto special = lookupTable(16, -1.0, 2.0);
  special->SetNanColor(0.1, 0.2, 0.3, 1.0);
  special->SetBelowRangeColor(0.9, 0.8, 0.7, 1.0);
  special->SetAboveRangeColor(0.3, 0.6, 0.5, 1.0);
  special->UseBelowRangeColorOn();
  special->UseAboveRangeColorOn();
  result.emplace_back("with special colours", special);
  auto logarithmic = lookupTable(100, 0.03, 7.0);
  logarithmic->SetScaleToLog10();
  result.emplace_back("logarithmic", logarithmic);
  auto own = lookupTable(4, -3.0, 4.0);
  own->Build();
  own->SetTableValue(2, 0.25, 0.5, 0.75, 0.5);
  result.emplace_back("with values set one by one", own);
  auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
  function->AddRGBPoint(-2.0, 0.0, 0.1, 0.2);
  function->AddRGBPoint(0.5, 1.0, 0.9, 0.3);
  function->AddRGBPoint(3.0, 0.2, 0.0, 0.8);
  function->SetColorSpaceToDiverging();
  result.emplace_back("a transfer function", function);
  auto discrete = vtkSmartPointer<vtkDiscretizableColorTransferFunction>::New();
  discrete->AddRGBPoint(-2.0, 0.0, 0.1, 0.2);
  discrete->AddRGBPoint(3.0, 1.0, 0.9, 0.3);
  discrete->DiscretizeOn();
  discrete->SetNumberOfValues(7);
  discrete->Build();
  result.emplace_back("a discretized transfer function", discrete);
  return result;
}

/// Numbers in and around the ranges of the tables, some of which are on the borders of entries.
Array numbers(const Array& array, int components, vtkIdType tuples, bool isReal)
{
  array->SetName("Number");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (vtkIdType k = 0; k < tuples * components; ++k)
  {
    const double number = static_cast<double>((k * 37) % 64) / 8.0 - 3.0;
    array->SetComponent(k / components, static_cast<int>(k % components),
      isReal && k % 29 == 5 ? notANumber : number);
  }
  return array;
}

/// What VTK makes of the array.
vtkSmartPointer<vtkUnsignedCharArray> mapped(
  vtkScalarsToColors* table, vtkDataArray* array, int component)
{
  component < 0 ? table->SetVectorModeToMagnitude() : table->SetVectorModeToComponent();
  table->Build();
  return vtkSmartPointer<vtkUnsignedCharArray>::Take(
    table->MapScalars(array, VTK_COLOR_MODE_DEFAULT, component));
}

/// Compares the pixels, one for each tuple, with the colours that VTK gives to the tuples, before
/// the black background.
void expectMapped(vtkImageData* image, vtkUnsignedCharArray* colors, const std::string& what)
{
  ASSERT_EQ(image->GetNumberOfPoints(), colors->GetNumberOfTuples()) << what;
  int wrong = 0;
  for (vtkIdType k = 0; k < colors->GetNumberOfTuples(); ++k)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const double expected =
        colors->GetComponent(k, channel) / 255.0 * (colors->GetComponent(k, 3) / 255.0);
      wrong += image->GetPointData()->GetScalars()->GetComponent(k, channel) !=
        std::floor(255.0 * expected + 0.5);
    }
  }
  EXPECT_EQ(wrong, 0) << what;
}

/// With isMappedLast, numbers must not be NaN, since NaN times 0 is NaN.
void expectLikeVTK(const std::string& what, vtkScalarsToColors* table, const Array& array,
  bool isOfCells, int component, bool isMappedLast = false)
{
  ColoredGrid grid(isOfCells);
  grid.add(array);
  grid.tracer->SetInputLookupTable(0, table);
  grid.tracer->SetInputColorComponent(0, component);
  grid.tracer->SetInputInterpolateScalarsBeforeMapping(0, isMappedLast);
  grid.tracer->Update();
  expectMapped(grid.tracer->GetOutput(), mapped(table, array, component), what);
}
}

TEST(Colors, OfPointsAreThoseOfMapScalars)
{
  for (const auto& [name, table] : tables())
  {
    const Array doubles =
      numbers(vtkSmartPointer<vtkDoubleArray>::New(), 3, ColoredGrid::points, true);
    const Array floats =
      numbers(vtkSmartPointer<vtkFloatArray>::New(), 1, ColoredGrid::points, true);
    const Array integers =
      numbers(vtkSmartPointer<vtkIntArray>::New(), 1, ColoredGrid::points, false);
    expectLikeVTK(name, table, doubles, false, 2);
    expectLikeVTK(name, table, floats, false, 0);
    expectLikeVTK(name, table, integers, false, 0);
    if (vtkLookupTable::SafeDownCast(table)) // others are sampled
    {
      expectLikeVTK(name, table, integers, false, 0, true);
    }
  }
}

TEST(Colors, OfCellsAreThoseOfMapScalars)
{
  for (const auto& [name, table] : tables())
  {
    const Array doubles =
      numbers(vtkSmartPointer<vtkDoubleArray>::New(), 1, ColoredGrid::cells, true);
    const Array integers =
      numbers(vtkSmartPointer<vtkShortArray>::New(), 2, ColoredGrid::cells, false);
    for (const bool isMappedLast : { false, true }) // which has no effect on cells
    {
      expectLikeVTK(name, table, doubles, true, 0, isMappedLast);
      expectLikeVTK(name, table, integers, true, 1, isMappedLast);
    }
  }
}

// The magnitude of a single number is the number, also if it is negative.
TEST(Colors, OfMagnitudesAreThoseOfMapScalars)
{
  for (const auto& [name, table] : tables())
  {
    for (const int components : { 1, 2, 3 })
    {
      expectLikeVTK(name, table,
        numbers(vtkSmartPointer<vtkDoubleArray>::New(), components, ColoredGrid::points, false),
        false, -1);
    }
  }
}

// Categories: annotated values, in order of the entries, whatever lies between them.
TEST(Colors, OfAnnotatedValuesAreThoseOfMapScalars)
{
  auto table = lookupTable(3, 0.0, 1.0);
  table->IndexedLookupOn();
  for (const double value : { -3.0, 1.5, 0.0, 2.25 })
  {
    table->SetAnnotation(value, std::to_string(value));
  }
  const Array integers = numbers(vtkSmartPointer<vtkIntArray>::New(), 1, ColoredGrid::cells, false);
  const Array doubles =
    numbers(vtkSmartPointer<vtkDoubleArray>::New(), 1, ColoredGrid::points, true);
  for (const bool isMappedLast : { false, true }) // which has no effect on categories
  {
    expectLikeVTK("integers", table, integers, true, 0, isMappedLast);
    expectLikeVTK("doubles", table, doubles, false, 0, isMappedLast);
  }
}

TEST(Colors, OfUnsignedCharAreTheBytesThemselves)
{
  for (int components = 1; components <= 4; ++components)
  {
    auto bytes = vtkSmartPointer<vtkUnsignedCharArray>::New();
    bytes->SetNumberOfComponents(components);
    bytes->SetNumberOfTuples(ColoredGrid::points);
    for (vtkIdType k = 0; k < bytes->GetNumberOfValues(); ++k)
    {
      bytes->SetValue(k, static_cast<unsigned char>(k * 53 % 256));
    }
    expectLikeVTK(
      std::to_string(components) + " components", lookupTable(4, 0, 1), bytes, false, 0);
  }
}

// Where a range is set, it replaces the table's; without a table, the default is the array's, and
// the colours go from red to blue.
TEST(Colors, RangeAndTableHaveDefaults)
{
  ColoredGrid grid(true);
  const Array array = numbers(vtkSmartPointer<vtkFloatArray>::New(), 1, ColoredGrid::cells, true);
  grid.add(array);
  grid.tracer->Update();
  double range[2];
  array->GetFiniteRange(range);
  auto rainbow = vtkSmartPointer<vtkLookupTable>::New();
  rainbow->SetRange(range);
  expectMapped(grid.tracer->GetOutput(), mapped(rainbow, array, 0), "the array's range");

  auto table = lookupTable(10, -0.5, 0.5);
  grid.tracer->SetInputLookupTable(0, table);
  grid.tracer->Update();
  expectMapped(grid.tracer->GetOutput(), mapped(table, array, 0), "the table's range");

  grid.tracer->SetInputScalarRange(0, -2.0, 1.0);
  grid.tracer->Update();
  EXPECT_EQ(table->GetRange()[0], -0.5); // it is not changed
  auto wider = lookupTable(10, -2.0, 1.0);
  expectMapped(grid.tracer->GetOutput(), mapped(wider, array, 0), "the given range");

  grid.tracer->ResetInputScalarRange(0);
  grid.tracer->Update();
  expectMapped(grid.tracer->GetOutput(), mapped(table, array, 0), "the table's range again");

  array->SetLookupTable(wider); // comes first, as in vtkMapper
  grid.mesh->Modified();
  grid.tracer->Update();
  expectMapped(grid.tracer->GetOutput(), mapped(wider, array, 0), "the array's table");
}

TEST(Colors, ChangeWithTheirTable)
{
  ColoredGrid grid(true);
  const Array array = numbers(vtkSmartPointer<vtkFloatArray>::New(), 1, ColoredGrid::cells, true);
  grid.add(array);
  auto table = lookupTable(4, -1.0, 1.0);
  grid.tracer->SetInputLookupTable(0, table);
  grid.tracer->Update();
  table->SetRange(-2.0, 2.0);
  grid.tracer->Update();
  expectMapped(grid.tracer->GetOutput(), mapped(table, array, 0), "the new range");
}

TEST(Colors, ComeFromTheArrayThatIsNamed)
{
  ColoredGrid grid(false);
  const Array points =
    numbers(vtkSmartPointer<vtkDoubleArray>::New(), 1, ColoredGrid::points, false);
  const Array cells = numbers(vtkSmartPointer<vtkIntArray>::New(), 1, ColoredGrid::cells, false);
  points->SetName("Other");
  grid.add(numbers(vtkSmartPointer<vtkIntArray>::New(), 1, ColoredGrid::points, false));
  grid.mesh->GetPointData()->AddArray(points);
  grid.mesh->GetCellData()->AddArray(cells);
  auto table = lookupTable(8, -1.0, 3.0);
  grid.tracer->SetInputLookupTable(0, table);
  grid.tracer->SetInputColorArray(0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Other");
  grid.tracer->Update();
  expectMapped(grid.tracer->GetOutput(), mapped(table, points, 0), "Other");

  // The lower left corner of the picture is a point of cell 0 only.
  grid.tracer->SetInputColorArray(0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Number");
  grid.tracer->Update();
  for (int channel = 0; channel < 3; ++channel)
  {
    EXPECT_EQ(grid.tracer->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, channel),
      mapped(table, cells, 0)->GetComponent(0, channel));
  }
}

// In the middle of an edge between a first and a last colour lies their mean, or the middle entry.
TEST(Colors, InterpolateColoursOrNumbers)
{
  ColoredGrid grid(true); // pixels show the middle of the squares
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("Number");
  array->SetNumberOfTuples(ColoredGrid::points);
  for (vtkIdType k = 0; k < ColoredGrid::points; ++k)
  {
    array->SetValue(k, k % (ColoredGrid::side + 1) % 2 ? 1.0f : 0.0f); // columns alternate
  }
  grid.mesh->GetPointData()->SetScalars(array);
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(3);
  table->SetRange(0.0, 1.0);
  table->Build();
  table->SetTableValue(0, 1.0, 0.0, 0.0);
  table->SetTableValue(1, 0.0, 1.0, 0.0);
  table->SetTableValue(2, 0.0, 0.0, 1.0);
  grid.tracer->SetInputLookupTable(0, table);
  grid.tracer->SetOutputScalarTypeToFloat();
  const auto color = [&](int channel)
  {
    grid.tracer->Update();
    return grid.tracer->GetOutput()->GetScalarComponentAsDouble(5, 3, 0, channel);
  };
  EXPECT_EQ(color(0), 0.5);
  EXPECT_EQ(color(1), 0.0);
  EXPECT_EQ(color(2), 0.5);
  grid.tracer->SetInputInterpolateScalarsBeforeMapping(0, true);
  EXPECT_EQ(color(0), 0.0);
  EXPECT_EQ(color(1), 1.0);
  EXPECT_EQ(color(2), 0.0);
}

// Sampled functions differ from MapScalars() by less than the change within an interval.
TEST(Colors, OfSampledFunctionsAreClose)
{
  for (const auto& [name, table] : tables())
  {
    if (vtkLookupTable::SafeDownCast(table) || name == "a discretized transfer function")
    {
      continue;
    }
    const Array array =
      numbers(vtkSmartPointer<vtkDoubleArray>::New(), 1, ColoredGrid::points, false);
    ColoredGrid grid(false);
    grid.add(array);
    grid.tracer->SetInputLookupTable(0, table);
    grid.tracer->SetInputInterpolateScalarsBeforeMapping(0, true);
    grid.tracer->Update();
    const auto expected = mapped(table, array, 0);
    for (vtkIdType k = 0; k < ColoredGrid::points; ++k)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        ASSERT_NEAR(
          grid.tracer->GetOutput()->GetPointData()->GetScalars()->GetComponent(k, channel),
          expected->GetComponent(k, channel), 1.0)
          << name << ", point " << k;
      }
    }
  }
}

TEST(Colors, OfSpheresAreThoseOfTheirPoints)
{
  for (const auto& [name, table] : tables())
  {
    ColoredGrid grid(false);
    const Array array =
      numbers(vtkSmartPointer<vtkDoubleArray>::New(), 1, ColoredGrid::points, true);
    grid.add(array);
    grid.tracer->SetInputLookupTable(0, table);
    grid.tracer->SetInputSphereRadius(0, 0.25);
    grid.property->BackfaceCullingOn();             // only the outside of transparent ones
    for (const bool isMappedLast : { false, true }) // which has no effect without interpolation
    {
      grid.tracer->SetInputInterpolateScalarsBeforeMapping(
        0, isMappedLast && vtkLookupTable::SafeDownCast(table));
      grid.tracer->Update();
      expectMapped(grid.tracer->GetOutput(), mapped(table, array, 0), name);
    }
  }
}

namespace
{
/// Three squares side by side as blocks. The first two have a number for their cell.
struct ColoredBlocks
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkCamera> camera;
  vtkNew<vtkProperty> property;
  vtkNew<vtkLambentRayTracer> tracer;

  ColoredBlocks()
  {
    for (int k = 0; k < 3; ++k)
    {
      vtkNew<vtkPoints> points;
      for (const auto& corner : { std::pair(0, 0), { 1, 0 }, { 1, 1 }, { 0, 1 } })
      {
        points->InsertNextPoint(k + corner.first, corner.second, 0.0);
      }
      vtkNew<vtkCellArray> squares;
      const vtkIdType corners[4] = { 0, 1, 2, 3 };
      squares->InsertNextCell(4, corners);
      vtkNew<vtkPolyData> mesh;
      mesh->SetPoints(points);
      mesh->SetPolys(squares);
      vtkNew<vtkDoubleArray> heat;
      heat->SetName("Heat");
      heat->InsertNextValue(10.0 * k);
      if (k < 2)
      {
        mesh->GetCellData()->AddArray(heat);
      }
      this->blocks->SetBlock(static_cast<unsigned int>(k), mesh);
    }
    this->camera->ParallelProjectionOn();
    this->camera->SetParallelScale(0.5);
    this->camera->SetFocalPoint(1.5, 0.5, 0.0);
    this->camera->SetPosition(1.5, 0.5, 1.0);
    this->property->LightingOff();
    this->property->SetColor(0.2, 0.4, 0.6);
    this->tracer->SetImageSize(3, 1);
    this->tracer->SetCamera(this->camera);
    this->tracer->SetProperty(this->property);
    this->tracer->SetInputData(this->blocks);
    this->tracer->SetInputScalarVisibility(0, true);
    this->tracer->SetInputColorArray(0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Heat");
  }

  /// The bytes of a pixel, which shows one block.
  std::array<int, 3> pixel(int block)
  {
    this->tracer->Update();
    std::array<int, 3> result{};
    for (int channel = 0; channel < 3; ++channel)
    {
      result[channel] = static_cast<int>(
        this->tracer->GetOutput()->GetScalarComponentAsDouble(block, 0, 0, channel));
    }
    return result;
  }
};
}

// The default table goes from red to blue, over the numbers of all blocks. A block without the
// array has the property's colour.
TEST(Colors, OfBlocksShareOneRange)
{
  ColoredBlocks colored;
  EXPECT_EQ(colored.pixel(0), (std::array<int, 3>{ 255, 0, 0 }));
  EXPECT_EQ(colored.pixel(1), (std::array<int, 3>{ 0, 0, 255 }));
  EXPECT_EQ(colored.pixel(2), (std::array<int, 3>{ 51, 102, 153 }));
}

TEST(Colors, OfBlocksThemselvesComeFirst)
{
  ColoredBlocks colored;
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  const double green[3] = { 0.0, 1.0, 0.0 };
  attributes->SetBlockColor(colored.blocks->GetBlock(1), green);
  colored.tracer->SetInputBlockAttributes(0, attributes);
  EXPECT_EQ(colored.pixel(0), (std::array<int, 3>{ 255, 0, 0 }));
  EXPECT_EQ(colored.pixel(1), (std::array<int, 3>{ 0, 255, 0 }));
}
