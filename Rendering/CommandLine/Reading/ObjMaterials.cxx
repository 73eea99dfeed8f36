// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ObjMaterials.h"

#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

namespace lambent::command
{
namespace
{

constexpr const char* LibrariesName = "MaterialLibraries";
constexpr const char* NamesName = "MaterialNames";
constexpr const char* NumbersName = "MaterialOfPolygon";

void StoreStrings(const std::vector<std::string>& strings, const char* name, vtkPolyData* mesh)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : strings)
  {
    array->InsertNextValue(text);
  }
  mesh->GetFieldData()->AddArray(array);
}

std::vector<std::string> StoredStrings(vtkPolyData* mesh, const char* name)
{
  std::vector<std::string> strings;
  auto* const array = vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(name));
  for (vtkIdType k = 0; array && k < array->GetNumberOfValues(); ++k)
  {
    strings.push_back(array->GetValue(k));
  }
  return strings;
}

} // namespace

void StoreMaterials(const ObjMaterials& materials, vtkPolyData* mesh)
{
  if (materials.empty())
  {
    return;
  }
  StoreStrings(materials.libraries, LibrariesName, mesh);
  StoreStrings(materials.names, NamesName, mesh);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(NumbersName);
  for (const std::int32_t number : materials.ofFace)
  {
    numbers->InsertNextValue(number);
  }
  mesh->GetFieldData()->AddArray(numbers);
}

ObjMaterials StoredMaterials(vtkPolyData* mesh)
{
  ObjMaterials materials;
  auto* const numbers = vtkIntArray::SafeDownCast(mesh->GetFieldData()->GetArray(NumbersName));
  if (numbers && numbers->GetNumberOfValues() == mesh->GetNumberOfPolys())
  {
    materials.libraries = StoredStrings(mesh, LibrariesName);
    materials.names = StoredStrings(mesh, NamesName);
    materials.ofFace.assign(
      numbers->GetPointer(0), numbers->GetPointer(0) + numbers->GetNumberOfValues());
  }
  for (std::int32_t& number : materials.ofFace) // other files may have arrays of these names
  {
    const bool isName = number >= 0 && static_cast<std::size_t>(number) < materials.names.size();
    number = isName ? number : ObjMaterials::none;
  }
  return materials;
}

} // namespace lambent::command
