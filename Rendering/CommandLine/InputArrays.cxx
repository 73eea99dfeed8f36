// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "InputArrays.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <set>
#include <utility>

namespace lambent::command
{
namespace
{

using Meshes = std::vector<vtkSmartPointer<vtkPolyData>>;
using Association = PassValue::Association;

constexpr std::size_t MostListed = 30;

std::set<std::string> NamesOf(const Meshes& meshes, Association association, bool withOwn)
{
  std::set<std::string> names;
  for (vtkPolyData* const mesh : meshes)
  {
    vtkDataSetAttributes* const arrays = AttributesOf(mesh, association);
    for (int k = 0; k < arrays->GetNumberOfArrays(); ++k)
    {
      const char* const name = arrays->GetArray(k) ? arrays->GetArrayName(k) : nullptr;
      if (name && (withOwn || !IsOwnArray(name))) // GetArray() is null for arrays of strings
      {
        names.insert(name);
      }
    }
  }
  return names;
}

bool IsSameLetter(char a, char b)
{
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

/// How far a name is from the one that was typed: a part of it, or one with more letters, is near.
std::size_t DistanceOf(const std::string& name, const std::string& typed)
{
  if (typed.empty())
  {
    return 0;
  }
  const auto contains = [](const std::string& text, const std::string& part)
  {
    return std::search(text.begin(), text.end(), part.begin(), part.end(), IsSameLetter) !=
      text.end();
  };
  const std::size_t distance = EditDistance(name, typed);
  const bool isPart = contains(name, typed) || contains(typed, name);
  return isPart ? std::min<std::size_t>(distance, 1) : distance;
}

} // namespace

vtkDataSetAttributes* AttributesOf(vtkPolyData* mesh, Association association)
{
  return association == Association::Cells
    ? static_cast<vtkDataSetAttributes*>(mesh->GetCellData())
    : static_cast<vtkDataSetAttributes*>(mesh->GetPointData());
}

vtkDataArray* ArrayOf(vtkPolyData* mesh, Association association, const std::string& name)
{
  return AttributesOf(mesh, association)->GetArray(name.c_str());
}

bool HasArray(const Meshes& meshes, Association association, const std::string& name)
{
  return std::any_of(meshes.begin(), meshes.end(),
    [&](vtkPolyData* mesh) { return ArrayOf(mesh, association, name) != nullptr; });
}

std::string ListArrays(const Meshes& meshes, const ArrayList& wanted)
{
  std::vector<std::pair<std::size_t, std::string>> list;
  for (const Association kind : { Association::Points, Association::Cells })
  {
    if (wanted.association != Association::Any && wanted.association != kind)
    {
      continue;
    }
    for (const std::string& name : NamesOf(meshes, kind, wanted.withOwn))
    {
      list.emplace_back(DistanceOf(name, wanted.nearest),
        (kind == Association::Points ? "point:" : "cell:") + name);
    }
  }
  std::stable_sort(
    list.begin(), list.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string text;
  for (std::size_t k = 0; k < std::min(list.size(), MostListed); ++k)
  {
    text += (k == 0 ? "" : ", ") + list[k].second;
  }
  if (list.size() > MostListed)
  {
    text += " and " + std::to_string(list.size() - MostListed) + " more, see --list";
  }
  return list.empty() ? "none" : text;
}

std::size_t EditDistance(const std::string& a, const std::string& b)
{
  // A row of the table of distances between the beginnings of both texts.
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t corner = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t replaced = corner + (IsSameLetter(a[i], b[j]) ? 0 : 1);
      corner = row[j + 1];
      row[j + 1] = std::min({ replaced, corner + 1, row[j] + 1 });
    }
  }
  return row.back();
}

} // namespace lambent::command
