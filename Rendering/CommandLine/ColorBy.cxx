// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ColorBy.h"
#include "InputArrays.h"
#include "Messages.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace lambent::command
{
namespace
{

using Meshes = std::vector<vtkSmartPointer<vtkPolyData>>;
using Association = PassValue::Association;

bool AnyHas(const Meshes& meshes, const ColorBy& colorBy)
{
  return std::any_of(meshes.begin(), meshes.end(),
    [&colorBy](vtkPolyData* mesh) { return ShownArrayOf(mesh, colorBy).has_value(); });
}

/// Whether an input has the array, but not as numbers.
bool IsText(const Meshes& meshes, const ColorBy& colorBy)
{
  const auto has = [&colorBy](vtkPolyData* mesh, Association association)
  {
    return colorBy.association !=
      (association == Association::Cells ? Association::Points : Association::Cells) &&
      AttributesOf(mesh, association)->GetAbstractArray(colorBy.array.c_str()) != nullptr;
  };
  return std::any_of(meshes.begin(), meshes.end(),
    [&has](vtkPolyData* mesh)
    { return has(mesh, Association::Points) || has(mesh, Association::Cells); });
}

/// The number of a component, or Magnitude; empty if the word is neither.
std::optional<int> ComponentNamed(const std::string& word)
{
  if (word == "magnitude")
  {
    return Magnitude;
  }
  const bool isNumber = !word.empty() && word.size() <= 6 &&
    std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
  return isNumber ? std::optional<int>(std::stoi(word)) : std::nullopt;
}

/// The text without point: or cell:, which choose the association.
ColorBy WithoutPrefix(const std::string& text)
{
  for (const auto& [prefix, association] :
    { std::pair("point:", Association::Points), std::pair("cell:", Association::Cells) })
  {
    const std::string start = prefix;
    if (text.compare(0, start.size(), start) == 0)
    {
      return { association, text.substr(start.size()), std::nullopt };
    }
  }
  return { Association::Any, text, std::nullopt };
}

[[noreturn]] void RefuseName(const std::string& text, const Meshes& meshes, const ColorBy& colorBy)
{
  ArrayList list;
  list.nearest = colorBy.array;
  const char* const why =
    IsText(meshes, colorBy) ? "it is an array of text" : "no input has such an array";
  throw WrongUsage(
    "--color-by " + text + ": " + why + "; the arrays of numbers are: " + ListArrays(meshes, list));
}

[[noreturn]] void RefuseComponent(
  const std::string& text, const ColorBy& colorBy, vtkDataArray* array)
{
  const int count = array->GetNumberOfComponents();
  std::string remedy = colorBy.array;
  if (count > 1)
  {
    remedy += ", " + colorBy.array + ":0 to " + colorBy.array + ":" + std::to_string(count - 1) +
      " or " + colorBy.array + ":magnitude";
  }
  throw WrongUsage("--color-by " + text + ": the array has " + std::to_string(count) +
    (count == 1 ? " component" : " components, counted from 0") + "; write " + remedy);
}

/// A component was typed; it must be one, and every input's array must have it.
void CheckComponent(const std::string& text, const ColorBy& colorBy, const Meshes& meshes)
{
  for (vtkPolyData* const mesh : meshes)
  {
    const auto shown = ShownArrayOf(mesh, colorBy);
    if (shown &&
      (!colorBy.component || *colorBy.component >= shown->array->GetNumberOfComponents()))
    {
      RefuseComponent(text, colorBy, shown->array);
    }
  }
}

} // namespace

ColorBy FindColorBy(const std::string& text, const Meshes& meshes)
{
  for (const ColorBy& whole :
    { ColorBy{ Association::Any, text, std::nullopt }, WithoutPrefix(text) })
  {
    if (AnyHas(meshes, whole))
    {
      return whole;
    }
  }
  ColorBy colorBy = WithoutPrefix(text);
  const std::size_t colon = colorBy.array.rfind(':');
  if (colon == std::string::npos)
  {
    RefuseName(text, meshes, colorBy);
  }
  const std::string component = colorBy.array.substr(colon + 1);
  colorBy.array.resize(colon);
  colorBy.component = ComponentNamed(component);
  if (!AnyHas(meshes, colorBy))
  {
    RefuseName(text, meshes, colorBy);
  }
  CheckComponent(text, colorBy, meshes);
  return colorBy;
}

std::optional<ShownArray> ShownArrayOf(vtkPolyData* mesh, const ColorBy& colorBy)
{
  for (const Association association : { Association::Points, Association::Cells })
  {
    const bool isWanted =
      colorBy.association == Association::Any || colorBy.association == association;
    vtkDataArray* const array = isWanted ? ArrayOf(mesh, association, colorBy.array) : nullptr;
    if (array && array->GetNumberOfComponents() > 0)
    {
      const int usual = array->GetNumberOfComponents() > 1 ? Magnitude : 0;
      return ShownArray{ array, association == Association::Cells,
        colorBy.component.value_or(usual), !colorBy.component && AreColors(array) };
    }
  }
  return std::nullopt;
}

bool AreColors(vtkDataArray* array)
{
  return array && array->GetDataType() == VTK_UNSIGNED_CHAR &&
    (array->GetNumberOfComponents() == 3 || array->GetNumberOfComponents() == 4);
}

} // namespace lambent::command
