// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Which pixels of a texture are colours, and which are mapped through a table.
#include "TexturedQuad.h"

#include "vtkColorTransferFunction.h"
#include "vtkLookupTable.h"
#include "vtkUnsignedCharArray.h"

namespace
{
constexpr int width = 17, height = 9;

const auto same = [](int i, int j) { return std::pair(i, j); };

/// The colours of an image of numbers, as VTK maps them.
vtkSmartPointer<vtkImageData> mapped(vtkImageData* image, vtkScalarsToColors* table, int mode)
{
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->SetDimensions(image->GetDimensions());
  table->Build();
  const auto colors = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    table->MapScalars(image->GetPointData()->GetScalars(), mode, -1));
  result->GetPointData()->SetScalars(colors);
  return result;
}
}

TEST(Textures, MapsNumbers)
{
  vtkNew<vtkLookupTable> table, logarithmic, several;
  table->SetRange(0.25, 0.75);
  table->SetUseBelowRangeColor(true);
  logarithmic->SetRange(0.01, 1.0);
  logarithmic->SetScaleToLog10();
  several->SetRange(0.0, 1.0);
  several->SetVectorModeToMagnitude();
  vtkNew<vtkColorTransferFunction> function;
  function->AddRGBPoint(0.0, 1.0, 0.5, 0.0);
  function->AddRGBPoint(1.0, 0.0, 0.5, 1.0);
  struct Case
  {
    vtkScalarsToColors* table;
    int components, type, mode;
  };
  for (const Case& c : { Case{ table, 1, VTK_FLOAT, VTK_COLOR_MODE_DEFAULT },
         Case{ table, 1, VTK_DOUBLE, VTK_COLOR_MODE_DEFAULT },
         Case{ logarithmic, 1, VTK_DOUBLE, VTK_COLOR_MODE_MAP_SCALARS },
         Case{ several, 3, VTK_FLOAT, VTK_COLOR_MODE_DEFAULT },
         Case{ function, 1, VTK_FLOAT, VTK_COLOR_MODE_DEFAULT },
         Case{ table, 1, VTK_UNSIGNED_CHAR, VTK_COLOR_MODE_MAP_SCALARS },
         Case{ table, 3, VTK_UNSIGNED_INT, VTK_COLOR_MODE_DIRECT_SCALARS },
         Case{ table, 1, VTK_FLOAT, VTK_COLOR_MODE_DIRECT_SCALARS } })
  {
    SCOPED_TRACE(std::string(c.table->GetClassName()) + " " + std::to_string(c.type));
    TexturedQuad scene(width, height);
    const auto image = makeImage(width, height, c.components, c.type);
    scene.texture->SetInputData(image);
    scene.texture->SetLookupTable(c.table);
    scene.texture->SetColorMode(c.mode);
    expectImage(scene, mapped(image, c.table, c.mode), same);
  }
}

TEST(Textures, MapsNumbersOverTheirRangeWithoutATable)
{
  TexturedQuad scene(width, height);
  const auto image = makeImage(width, height, 1, VTK_FLOAT);
  scene.texture->SetInputData(image);
  vtkNew<vtkLookupTable> table;
  table->SetRange(image->GetPointData()->GetScalars()->GetRange(0));
  expectImage(scene, mapped(image, table, VTK_COLOR_MODE_DEFAULT), same);
  EXPECT_EQ(scene.texture->GetLookupTable(), nullptr); // it is not changed
  EXPECT_EQ(scene.texture->GetMappedScalars(), nullptr);
}

TEST(Textures, DirectScalars)
{
  for (const int type : { VTK_UNSIGNED_SHORT, VTK_FLOAT })
  {
    TexturedQuad scene(width, height);
    const auto image = makeImage(width, height, 3, type);
    scene.tracer->SetOutputScalarTypeToFloat();
    scene.texture->SetInputData(image);
    scene.texture->SetColorModeToDirectScalars();
    const Picture picture = render(scene.tracer);
    for (int i = 0; i < width; ++i)
    {
      const Vec color = colorOf(image, i, 2) / (type == VTK_FLOAT ? 1.0 : 65535.0);
      expectColor(picture.at(i, 2), color, pixelName(i, 2), 1e-7);
    }
  }
}
