// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LegacyGrid.h"
#include "HigherOrder.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace lambent::command
{
namespace
{

/// Whether the points of a polyhedron are valid: "number of faces, number of points of a face, ids,
/// number of points of a face, ids, ...".
bool IsStreamOfFaces(vtkIdType size, const vtkIdType* stream)
{
  if (size < 1 || stream[0] < 1)
  {
    return false;
  }
  vtkIdType at = 1;
  for (vtkIdType left = stream[0]; left > 0; --left)
  {
    if (at >= size || stream[at] < 0 || stream[at] > size - at - 1)
    {
      return false;
    }
    at += stream[at] + 1;
  }
  return at == size;
}

} // namespace

void SetLegacyCells(vtkUnstructuredGrid* grid, vtkCellArray* cells, std::vector<int>& types)
{
  const vtkIdType count = cells->GetNumberOfCells();
  if (static_cast<vtkIdType>(types.size()) != count)
  {
    throw Failure("it has " + std::to_string(count) + " CELLS and " + std::to_string(types.size()) +
      " CELL_TYPES; use a complete copy");
  }
  vtkNew<vtkIdList> stream;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    const int type = types[static_cast<std::size_t>(cell)];
    if (type < 0 || type > 255)
    {
      throw Failure("its cell " + std::to_string(cell) + " is of type " + std::to_string(type) +
        ", but there is no such type" + CorrectCell);
    }
    if (type == VTK_POLYHEDRON)
    {
      cells->GetCellAtId(cell, stream);
      if (!IsStreamOfFaces(stream->GetNumberOfIds(), stream->GetPointer(0)))
      {
        throw Failure("it is corrupt: the faces of its cell " + std::to_string(cell) +
          " do not add up; use a complete copy");
      }
    }
  }
  grid->SetCells(types.data(), cells);
}

} // namespace lambent::command
