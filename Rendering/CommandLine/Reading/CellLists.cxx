// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellLists.h"

#include "vtkCellArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <limits>

namespace lambent::command
{

vtkSmartPointer<vtkCellArray> MakeCellArray(const CellLists& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  if (cells.points.size() <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
  {
    array->SetData(MakeArray<vtkTypeInt32Array>(cells.offsets, 1),
      MakeArray<vtkTypeInt32Array>(cells.points, 1));
  }
  else
  {
    array->SetData(MakeArray<vtkTypeInt64Array>(cells.offsets, 1),
      MakeArray<vtkTypeInt64Array>(cells.points, 1));
  }
  return array;
}

} // namespace lambent::command
