// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColorScale.h"
#include "Messages.h"

#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace lambent::command
{
namespace
{

using Meshes = std::vector<vtkSmartPointer<vtkPolyData>>;
using Range = std::array<double, 2>;

constexpr double Infinity = std::numeric_limits<double>::infinity();

std::string TextOf(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

double NumberAt(const ShownArray& shown, vtkIdType tuple)
{
  if (shown.component != Magnitude)
  {
    return shown.array->GetComponent(tuple, shown.component);
  }
  double sum = 0;
  for (int k = 0; k < shown.array->GetNumberOfComponents(); ++k)
  {
    const double value = shown.array->GetComponent(tuple, k);
    sum += value * value;
  }
  return std::sqrt(sum);
}

/// Finite numbers only; empty (from infinity to -infinity) if there are none.
Range FiniteRange(const ShownArray& shown)
{
  Range range = { Infinity, -Infinity };
  if (shown.array->GetNumberOfTuples() > 0)
  {
    shown.array->GetFiniteRange(range.data(), shown.component);
  }
  const bool isOneNumber = shown.array->GetNumberOfComponents() == 1;
  if (isOneNumber && shown.component == Magnitude && range[0] < 0) // VTK gives that of the number
  {
    range = { 0, std::max(-range[0], range[1]) };
  }
  return range;
}

/// The smallest number above 0; infinity if there is none.
double SmallestPositive(const ColorBy& colorBy, const Meshes& meshes)
{
  double smallest = Infinity;
  for (vtkPolyData* const mesh : meshes)
  {
    const auto shown = ShownArrayOf(mesh, colorBy);
    for (vtkIdType k = 0; shown && k < shown->array->GetNumberOfTuples(); ++k)
    {
      const double number = NumberAt(*shown, k);
      smallest = number > 0 ? std::min(smallest, number) : smallest;
    }
  }
  return smallest;
}

[[noreturn]] void RefuseLogarithm(const Range& range, const ColorBy& colorBy, const Meshes& meshes)
{
  const double smallest = std::max(SmallestPositive(colorBy, meshes), range[1] / 1000);
  throw WrongUsage("--log: " + colorBy.array + " goes from " + TextOf(range[0]) + " to " +
    TextOf(range[1]) + ", but a logarithm needs numbers above 0; " +
    (smallest < range[1]
        ? "set --range, such as --range " + TextOf(smallest) + "," + TextOf(range[1]) + ", or "
        : "") +
    "omit --log");
}

} // namespace

Range RangeOf(const Options& options, const ColorBy& colorBy, const Meshes& meshes)
{
  if (options.colors.range)
  {
    return *options.colors.range; // CheckColors() has seen it
  }
  Range range = { Infinity, -Infinity };
  for (vtkPolyData* const mesh : meshes)
  {
    const auto shown = ShownArrayOf(mesh, colorBy);
    if (shown && !shown->areColors)
    {
      const Range own = FiniteRange(*shown);
      range = { std::min(range[0], own[0]), std::max(range[1], own[1]) };
    }
  }
  if (range[0] > range[1])
  {
    return { options.colors.isLogarithmic ? 0.1 : 0.0, 1 };
  }
  if (options.colors.isLogarithmic && range[0] <= 0)
  {
    RefuseLogarithm(range, colorBy, meshes);
  }
  // Rounding errors of a constant, such as the array of a contour, are not worth different colours.
  const double noise = 1e-6 * std::max(std::fabs(range[0]), std::fabs(range[1]));
  return range[1] - range[0] < noise ? Range{ range[0], range[0] + 500 * noise } : range;
}

vtkSmartPointer<vtkLookupTable> MakeTable(const ColorOptions& options, const Range& range)
{
  const ColorTable256 colors = *FindColorMap(options.map.value_or(DefaultColorMap));
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(256);
  for (int k = 0; k < 256; ++k)
  {
    table->SetTableValue(k, colors[k][0] / 255.0, colors[k][1] / 255.0, colors[k][2] / 255.0);
  }
  table->SetTableRange(range[0], range[1]);
  if (options.isLogarithmic)
  {
    table->SetScaleToLog10();
  }
  if (options.nan)
  {
    const Triple& nan = *options.nan;
    table->SetNanColor(nan[0], nan[1], nan[2], 1);
  }
  return table;
}

} // namespace lambent::command
