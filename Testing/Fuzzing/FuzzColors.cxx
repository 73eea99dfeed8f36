// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzColors.h"

#include "FuzzChanges.h"

#include "vtkColorTransferFunction.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkVariant.h"

#include <array>

namespace
{
std::array<double, 4> makeColor(FuzzInput& input)
{
  std::array<double, 4> color{};
  for (double& channel : color)
  {
    channel = input.within(0.0, 1.0);
  }
  return color;
}

/// Usually above 0, for the logarithm.
double makeLimit(FuzzInput& input)
{
  return input.seldom() ? input.number() : input.within(0.01, 3.0);
}

vtkSmartPointer<vtkScalarsToColors> makeFunction(FuzzInput& input)
{
  auto function = vtkSmartPointer<vtkColorTransferFunction>::New();
  function->SetColorSpace(input.choice(6));
  function->SetClamping(input.flag());
  if (input.seldom(64))
  {
    function->SetScaleToLog10();
  }
  const int count = input.seldom() ? 0 : 1 + input.choice(3);
  for (int k = 0; k < count; ++k)
  {
    const double at = input.within(0.01, 3.0);
    const auto color = makeColor(input);
    function->AddRGBPoint(at, color[0], color[1], color[2]);
  }
  return function;
}

vtkSmartPointer<vtkTransform> makeTransform(FuzzInput& input)
{
  auto transform = vtkSmartPointer<vtkTransform>::New();
  vtkNew<vtkMatrix4x4> matrix;
  for (int k = 0; k < (input.seldom(16) ? 16 : 8); ++k)
  {
    matrix->SetElement(k / 4, k % 4, input.seldom(4) ? input.number() : input.within(-2.0, 2.0));
  }
  transform->SetMatrix(matrix);
  return transform;
}
}

vtkSmartPointer<vtkLookupTable> makeFuzzLookupTable(FuzzInput& input)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  const int bits = input.byte();
  if ((bits & 1) != 0)
  {
    table->SetNumberOfTableValues(input.seldom() ? 0 : 1 + input.choice(6));
    for (vtkIdType k = 0; k < table->GetNumberOfTableValues(); ++k)
    {
      table->SetTableValue(k, makeColor(input).data());
    }
  }
  table->SetUseBelowRangeColor((bits & 2) != 0);
  table->SetUseAboveRangeColor((bits & 4) != 0);
  if ((bits & 8) != 0)
  {
    table->SetBelowRangeColor(makeColor(input).data());
    table->SetAboveRangeColor(makeColor(input).data());
    table->SetNanColor(makeColor(input).data());
  }
  const double low = makeLimit(input), high = makeLimit(input);
  if ((bits & 16) != 0)
  {
    table->SetTableRange(low, high);
  }
  if ((bits & 32) != 0)
  {
    table->SetScaleToLog10();
  }
  if ((bits & 64) != 0)
  {
    table->SetAlpha(input.within(0.0, 1.0));
  }
  if ((bits & 128) != 0 && input.seldom(64))
  {
    table->SetAnnotation(vtkVariant(input.number()), "annotation");
    table->SetIndexedLookup(input.flag());
  }
  return table;
}

vtkSmartPointer<vtkScalarsToColors> makeFuzzTable(FuzzInput& input)
{
  if (input.seldom(64))
  {
    return makeFunction(input);
  }
  return makeFuzzLookupTable(input);
}

vtkSmartPointer<vtkTexture> makeFuzzTexture(FuzzInput& input)
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  const int bits = input.byte();
  texture->SetInterpolate((bits & 1) != 0);
  texture->SetUseSRGBColorSpace((bits & 2) != 0);
  texture->SetWrap((bits >> 2) & 3);
  texture->SetColorMode(input.seldom(64) ? input.choice(3) : VTK_COLOR_MODE_DEFAULT);
  if ((bits & 16) != 0)
  {
    texture->SetLookupTable(makeFuzzTable(input));
  }
  if ((bits & 32) != 0)
  {
    texture->SetTransform(makeTransform(input));
  }
  if ((bits & 64) != 0)
  {
    const auto color = makeColor(input);
    texture->SetBorderColor(static_cast<float>(color[0]), static_cast<float>(color[1]),
      static_cast<float>(color[2]), static_cast<float>(color[3]));
  }
  texture->SetMipmap((bits & 128) != 0);
  texture->SetCubeMap(input.seldom(2));
  if (!input.seldom(4))
  {
    texture->SetInputData(makeFuzzImage(input));
  }
  return texture;
}
