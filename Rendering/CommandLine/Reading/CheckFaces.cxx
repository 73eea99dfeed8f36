// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckFaces.h"
#include "HigherOrder.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <string>

namespace lambent::command
{
namespace
{

[[noreturn]] void FailForFaces(vtkIdType cell, const std::string& what)
{
  throw Failure(CellWithType(cell, VTK_POLYHEDRON) + what + CorrectCell);
}

void CheckPoint(vtkUnstructuredGrid* grid, vtkIdType cell, vtkIdType id)
{
  const vtkIdType points = grid->GetNumberOfPoints();
  if (id < 0 || id >= points)
  {
    FailForFaces(cell,
      " has a face that uses point " + std::to_string(id) +
        ", which does not exist: the file has " + std::to_string(points) +
        " points, numbered from 0");
  }
}

} // namespace

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)

/// The faces form a cell array, and each polyhedron is a list of ids in it.
void CheckFaces(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkCellArray* const faces = grid->GetPolyhedronFaces();
  vtkCellArray* const facesOfCells = grid->GetPolyhedronFaceLocations();
  if (!faces || !facesOfCells || cell >= facesOfCells->GetNumberOfCells() ||
    facesOfCells->GetCellSize(cell) == 0)
  {
    FailForFaces(cell, " has no faces");
  }
  vtkNew<vtkIdList> ofCell;
  vtkNew<vtkIdList> ofFace;
  facesOfCells->GetCellAtId(cell, ofCell);
  for (const vtkIdType face : *ofCell)
  {
    if (face < 0 || face >= faces->GetNumberOfCells())
    {
      FailForFaces(cell, " has a face that does not exist");
    }
    faces->GetCellAtId(face, ofFace);
    for (const vtkIdType id : *ofFace)
    {
      CheckPoint(grid, cell, id);
    }
  }
}

#else

/// At the polyhedron's location, the list of faces holds the number of faces, then for each face
/// the number of points and the point ids.
void CheckFaces(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkIdTypeArray* const faces = grid->GetFaces();
  vtkIdTypeArray* const starts = grid->GetFaceLocations();
  const vtkIdType size = faces ? faces->GetNumberOfValues() : 0;
  vtkIdType at = starts && cell < starts->GetNumberOfValues() ? starts->GetValue(cell) : -1;
  if (at < 0 || at >= size || faces->GetValue(at) <= 0)
  {
    FailForFaces(cell, " has no faces");
  }
  for (vtkIdType left = faces->GetValue(at++); left > 0; --left)
  {
    vtkIdType points = at < size ? faces->GetValue(at++) : -1;
    if (points < 0 || points > size - at)
    {
      FailForFaces(cell, " has inconsistent faces");
    }
    for (; points > 0; --points)
    {
      CheckPoint(grid, cell, faces->GetValue(at++));
    }
  }
}

#endif

} // namespace lambent::command
