// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ChangedCells.h"

#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <map>
#include <utility>

namespace lambent::command
{
namespace
{

constexpr std::size_t MostRanges = 12; ///< listed for each input

bool IsChanged(vtkDataArray* difference, vtkIdType pixel)
{
  for (int channel = 0; channel < difference->GetNumberOfComponents(); ++channel)
  {
    if (difference->GetComponent(pixel, channel) != 0)
    {
      return true;
    }
  }
  return false;
}

/// The cells of one input in words: "cells 3, 7-12 and 5 others".
std::string DescribeIds(const std::vector<vtkIdType>& ids)
{
  std::string text;
  std::size_t ranges = 0, k = 0;
  for (; k < ids.size() && ranges < MostRanges; ++ranges)
  {
    std::size_t end = k + 1;
    for (; end < ids.size() && ids[end] == ids[end - 1] + 1; ++end)
    {
    }
    text += (k == 0 ? "" : ", ") + std::to_string(ids[k]);
    text += end == k + 1 ? "" : "-" + std::to_string(ids[end - 1]);
    k = end;
  }
  const std::size_t others = ids.size() - k;
  return (ids.size() == 1 ? "cell " : "cells ") + text +
    (others == 0 ? "" : " and " + std::to_string(others) + (others == 1 ? " other" : " others"));
}

} // namespace

std::vector<ChangedCell> FindChangedCells(vtkImageData* difference, const PixelIds& ids)
{
  vtkDataArray* const values = difference->GetPointData()->GetScalars();
  const int width = difference->GetDimensions()[0];
  std::map<std::pair<vtkIdType, vtkIdType>, ChangedCell> found;
  for (vtkIdType pixel = 0; pixel < values->GetNumberOfTuples(); ++pixel)
  {
    if (IsChanged(values, pixel))
    {
      const vtkIdType input = ids.inputs->GetValue(pixel), cell = ids.cells->GetValue(pixel);
      const int x = static_cast<int>(pixel % width), y = static_cast<int>(pixel / width);
      ++found.try_emplace({ input, cell }, ChangedCell{ input, cell, 0, x, y })
          .first->second.pixels;
    }
  }
  std::vector<ChangedCell> cells;
  for (const auto& entry : found)
  {
    cells.push_back(entry.second);
  }
  return cells;
}

std::string Describe(
  const std::vector<ChangedCell>& cells, const std::vector<std::string>& inputNames)
{
  std::vector<std::string> parts;
  for (std::size_t input = 0; input < inputNames.size(); ++input)
  {
    std::vector<vtkIdType> ids;
    for (const ChangedCell& changed : cells)
    {
      if (changed.input == static_cast<vtkIdType>(input))
      {
        ids.push_back(changed.cell);
      }
    }
    if (!ids.empty())
    {
      parts.push_back(DescribeIds(ids) + " of '" + inputNames[input] + "'");
    }
  }
  if (!cells.empty() && cells.front().input < 0)
  {
    parts.emplace_back("the background");
  }
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k)
  {
    text += (k == 0 ? "" : k + 1 == parts.size() ? " and " : ", ") + parts[k];
  }
  return text;
}

} // namespace lambent::command
