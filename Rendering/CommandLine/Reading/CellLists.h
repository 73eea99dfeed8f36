// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief points and cells as readers of text gather them, and the arrays of VTK made of them
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

/// Lists of point ids one after the other: list i is from offsets[i] to offsets[i + 1].
struct CellLists
{
  std::vector<std::int64_t> offsets{ 0 };
  std::vector<std::int32_t> points;

  std::size_t size() const { return this->offsets.size() - 1; }
  /// Ends the list that the points behind the last offset make up.
  void EndCell() { this->offsets.push_back(static_cast<std::int64_t>(this->points.size())); }
};

/// With ids of 32 bits, which take half the room, where they can count the points of all cells.
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
