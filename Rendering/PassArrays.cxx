// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PassArrays.h"

#include "PassTable.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace lambent::adapters
{
namespace
{
vtkDataSetAttributes* attributes(vtkPolyData* input, int association)
{
  return association == vtkDataObject::FIELD_ASSOCIATION_POINTS
    ? static_cast<vtkDataSetAttributes*>(input->GetPointData())
    : input->GetCellData();
}

/// Returns the first error in the names or associations with its remedy, or an empty string.
std::string describeDefect(const std::vector<SceneSettings::PassArray>& arrays)
{
  std::set<std::string> taken{ "Color", "CellIds", "InputIds", "BlockIds" };
  for (const PassEntry& entry : passTable)
  {
    taken.insert(entry.name);
  }
  for (const SceneSettings::PassArray& array : arrays)
  {
    if (array.association != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
      array.association != vtkDataObject::FIELD_ASSOCIATION_CELLS)
    {
      return "AddPassArray() was given the association " + std::to_string(array.association) +
        " for \"" + array.name +
        "\"; it takes vtkDataObject::FIELD_ASSOCIATION_POINTS (0) or FIELD_ASSOCIATION_CELLS (1). "
        "Call RemoveAllPassArrays() and add it again.";
    }
    if (!taken.insert(array.name).second)
    {
      return "AddPassArray() was given the " + describe(array) +
        ", but the picture has another array of that name. Rename the input's array, and call "
        "RemoveAllPassArrays().";
    }
  }
  return "";
}
}

std::string listArrays(const std::vector<vtkPolyData*>& inputs, int association)
{
  std::set<std::string> names;
  for (vtkPolyData* const input : inputs)
  {
    vtkDataSetAttributes* const arrays = attributes(input, association);
    for (int k = 0; k < arrays->GetNumberOfArrays(); ++k)
    {
      const char* const name = arrays->GetArray(k) ? arrays->GetArrayName(k) : nullptr;
      names.insert(name ? "\"" + std::string(name) + "\"" : "");
    }
  }
  names.erase("");
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

std::string describe(const SceneSettings::PassArray& array)
{
  const bool isOfPoints = array.association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  return std::string(isOfPoints ? "point" : "cell") + " array \"" + array.name + "\"";
}

void checkNames(const std::vector<SceneSettings::PassArray>& arrays)
{
  const std::string defect = describeDefect(arrays);
  if (!defect.empty())
  {
    throw std::runtime_error(defect);
  }
}

vtkDataArray* findArray(vtkPolyData* input, const SceneSettings::PassArray& array)
{
  return attributes(input, array.association)->GetArray(array.name.c_str());
}

std::vector<std::string> describeMissing(const SceneSettings& settings)
{
  std::vector<std::string> messages;
  if (!describeDefect(settings.passArrays).empty())
  {
    return messages; // rendering will fail with that error
  }
  for (const SceneSettings::PassArray& array : settings.passArrays)
  {
    const bool isFound = std::any_of(settings.inputs.begin(), settings.inputs.end(),
      [&](const SceneSettings::Input& input) { return findArray(input.mesh, array) != nullptr; });
    if (!isFound)
    {
      std::vector<vtkPolyData*> inputs;
      for (const SceneSettings::Input& input : settings.inputs)
      {
        inputs.push_back(input.mesh);
      }
      const std::string list = listArrays(inputs, array.association);
      messages.push_back("AddPassArray() was given the " + describe(array) +
        ", which no input has; its values are NaN. " +
        (list.empty() ? "The inputs have none." : "The inputs have " + list + "."));
    }
  }
  return messages;
}
}
