// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckCells.h"
#include "HigherOrder.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <string>

namespace lambent::command
{
namespace
{

/// Whether the offsets increase from 0 to the number of ids.
template <typename Array>
bool AreOffsetsSound(Array* offsets, Array* connectivity)
{
  const vtkIdType count = offsets->GetNumberOfValues();
  if (count < 1 || offsets->GetValue(0) != 0 ||
    offsets->GetValue(count - 1) != connectivity->GetNumberOfValues())
  {
    return false;
  }
  const auto* const values = offsets->GetPointer(0);
  return std::is_sorted(values, values + count);
}

/// The place of the first id that is not that of a point; the number of ids if there is none.
template <typename Array>
vtkIdType FirstWrongId(Array* connectivity, vtkIdType numberOfPoints)
{
  constexpr vtkIdType step = 4096; // of which a vector unit looks at several at once
  const vtkIdType count = connectivity->GetNumberOfValues();
  const auto* const ids = connectivity->GetPointer(0);
  const auto isWrong = [numberOfPoints](auto id) { return id < 0 || id >= numberOfPoints; };
  for (vtkIdType begin = 0; begin < count; begin += step)
  {
    const auto* const end = ids + std::min(begin + step, count);
    bool anyIsWrong = false;
    for (const auto* id = ids + begin; id < end; ++id)
    {
      anyIsWrong |= isWrong(*id);
    }
    if (anyIsWrong)
    {
      return std::find_if(ids + begin, end, isWrong) - ids;
    }
  }
  return count;
}

template <typename Array>
void CheckOffsetsOf(Array* offsets, Array* connectivity, const std::string& word)
{
  if (!AreOffsetsSound(offsets, connectivity))
  {
    throw Failure("it is broken: where each " + word +
      " begins in the list of their points does not add up; get a whole copy of it");
  }
}

template <typename Array>
void CheckIds(
  Array* offsets, Array* connectivity, vtkIdType numberOfPoints, const std::string& word)
{
  const vtkIdType at = FirstWrongId(connectivity, numberOfPoints);
  if (at < connectivity->GetNumberOfValues())
  {
    const auto* const values = offsets->GetPointer(0);
    const auto* const next = std::upper_bound(values, values + offsets->GetNumberOfValues(), at);
    throw Failure("its " + word + " " + std::to_string(next - values - 1) + " names point " +
      std::to_string(connectivity->GetValue(at)) + ", which does not exist: the file has " +
      std::to_string(numberOfPoints) + " points, from 0 on; correct it in the program that " +
      "writes the file, or get a whole copy");
  }
}

/// What is expected of the points of a cell.
struct Points
{
  bool IsKnown = false;   ///< there is such a type
  vtkIdType Exactly = 0;  ///< if this is not 0
  bool IsEven = false;    ///< corners, and as many nodes between them
  bool IsLooked = false;  ///< this has been looked up
};

Points PointsOfType(int type)
{
  Points points;
  points.IsLooked = true;
  points.IsEven = type == VTK_QUADRATIC_POLYGON;
  if (type == VTK_EMPTY_CELL)
  {
    points.IsKnown = true;
    return points;
  }
  const auto cell = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  points.IsKnown = cell != nullptr;
  points.Exactly = cell ? cell->GetNumberOfPoints() : 0;
  return points;
}

void CheckCount(const Points& points, vtkIdType count, vtkIdType cell, int type)
{
  if (!points.IsKnown)
  {
    throw Failure(CellWithType(cell, type) + " has " + std::to_string(count) +
      " points, and there is no such type" + CorrectCell);
  }
  if (points.Exactly > 0 && points.Exactly != count)
  {
    throw Failure(CellWithType(cell, type) + " has " + std::to_string(count) +
      " points and not " + std::to_string(points.Exactly) + CorrectCell);
  }
  if (points.IsEven && (count % 2 != 0 || count < 6))
  {
    throw Failure(CellWithType(cell, type) + " has " + std::to_string(count) +
      " points; such cells have 6, 8, 10, ... points" + CorrectCell);
  }
}

/// The faces of a polyhedron name points that exist.
void CheckFaces(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  vtkNew<vtkIdList> stream; // the number of faces; then of each the number of points, and these
  grid->GetFaceStream(cell, stream);
  const vtkIdType size = stream->GetNumberOfIds();
  vtkIdType at = 1;
  for (vtkIdType left = size > 0 ? stream->GetId(0) : 0; left > 0 && at < size; --left)
  {
    const vtkIdType end = at + 1 + stream->GetId(at);
    for (++at; at < std::min(end, size); ++at)
    {
      const vtkIdType id = stream->GetId(at);
      if (id < 0 || id >= grid->GetNumberOfPoints())
      {
        throw Failure(CellWithType(cell, VTK_POLYHEDRON) + " has a face that names point " +
          std::to_string(id) + ", which does not exist: the file has " +
          std::to_string(grid->GetNumberOfPoints()) + " points, from 0 on" + CorrectCell);
      }
    }
  }
}

} // namespace

void CheckOffsets(vtkCellArray* cells, const char* word)
{
  cells->IsStorage64Bit()
    ? CheckOffsetsOf(cells->GetOffsetsArray64(), cells->GetConnectivityArray64(), word)
    : CheckOffsetsOf(cells->GetOffsetsArray32(), cells->GetConnectivityArray32(), word);
}

void CheckCells(vtkCellArray* cells, vtkIdType numberOfPoints, const char* word)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  CheckOffsets(cells, word);
  cells->IsStorage64Bit()
    ? CheckIds(cells->GetOffsetsArray64(), cells->GetConnectivityArray64(), numberOfPoints, word)
    : CheckIds(cells->GetOffsetsArray32(), cells->GetConnectivityArray32(), numberOfPoints, word);
}

void CheckCells(vtkUnstructuredGrid* grid)
{
  vtkCellArray* const cells = grid->GetCells();
  CheckCells(cells, grid->GetNumberOfPoints());
  std::array<Points, 256> pointsOfType; // a type is a byte
  const unsigned char* const types = grid->GetCellTypesArray()->GetPointer(0);
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = types[cell];
    if (HigherOrderShape(type) != Shape::Linear)
    {
      CheckHigherOrder(grid, cell, type);
      continue;
    }
    Points& points = pointsOfType.at(static_cast<std::size_t>(type));
    if (!points.IsLooked)
    {
      points = PointsOfType(type);
    }
    CheckCount(points, cells->GetCellSize(cell), cell, type);
    if (type == VTK_POLYHEDRON)
    {
      CheckFaces(grid, cell);
    }
  }
}

} // namespace lambent::command
