// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckCells.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkDataArrayRange.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <optional>
#include <string>

namespace lambent::command
{
namespace
{

/// Points of a cell of that type, 0 if it may have any number; nothing for an unknown type.
std::optional<vtkIdType> PointsOfType(int type)
{
  if (type == VTK_EMPTY_CELL)
  {
    return 0;
  }
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  return cell ? std::make_optional(cell->GetNumberOfPoints()) : std::nullopt;
}

} // namespace

void CheckCells(vtkCellArray* cells, vtkIdType numberOfPoints)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  bool isSound = cells->IsValid();
  const auto check = [&isSound, numberOfPoints](auto* connectivity)
  {
    for (const auto id : vtk::DataArrayValueRange<1>(connectivity))
    {
      isSound &= id >= 0 && id < numberOfPoints;
    }
  };
  if (cells->IsStorage64Bit())
  {
    check(cells->GetConnectivityArray64());
  }
  else
  {
    check(cells->GetConnectivityArray32());
  }
  if (!isSound)
  {
    throw Failure("it has a cell that names a point that does not exist, of " +
      std::to_string(numberOfPoints) + " points; get a whole copy of it");
  }
}

void CheckCells(vtkUnstructuredGrid* grid)
{
  CheckCells(grid->GetCells(), grid->GetNumberOfPoints());
  std::array<std::optional<std::optional<vtkIdType>>, 256> pointsOfType; // a type is a byte
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    auto& expected = pointsOfType.at(static_cast<std::size_t>(type));
    if (!expected)
    {
      expected = PointsOfType(type);
    }
    const vtkIdType count = grid->GetCells()->GetCellSize(cell);
    if (!*expected || (**expected > 0 && **expected != count))
    {
      throw Failure("its cell " + std::to_string(cell) + " of type " + std::to_string(type) +
        " has " + std::to_string(count) + " points" +
        (*expected ? " and not " + std::to_string(**expected) : ", and there is no such type") +
        "; get a whole copy of it");
    }
  }
}

} // namespace lambent::command
