// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief lists of cells as the text readers collect them, and their conversion to VTK arrays
 */

#ifndef CellLists_h
#define CellLists_h

#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

class vtkCellArray;

namespace lambent::command
{

/// Consecutive lists of point ids: list i starts at offsets[i] and ends before offsets[i + 1].
struct CellLists
{
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<std::int32_t> points;

  std::size_t size() const { return this->offsets.size() - 1; }
  /// Ends the list of the points after the last offset.
  void EndCell() { this->offsets.push_back(static_cast<std::int64_t>(this->points.size())); }
};

/// Uses 32-bit ids, which take half the memory, if they can count the points of all cells.
vtkSmartPointer<vtkCellArray> MakeCellArray(const CellLists& cells);

template <typename Array, typename Value>
vtkSmartPointer<Array> MakeArray(const std::vector<Value>& values, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::transform(values.begin(), values.end(), array->GetPointer(0),
    [](Value value) { return static_cast<typename Array::ValueType>(value); });
  return array;
}

} // namespace lambent::command

#endif
