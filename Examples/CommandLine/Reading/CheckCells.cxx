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
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <string>
#include <type_traits>

namespace lambent::command
{
namespace
{

/// Whether wrong(begin, end) returns a number of the highest bit 0 for all parts of the range. As a
/// sum of bits it takes many numbers at once, and this is as fast as memory.
template <typename Wrong>
bool IsRight(vtkIdType count, const Wrong& wrong)
{
  std::atomic<bool> isRight{ true };
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      if (wrong(begin, end) < 0)
      {
        isRight = false;
      }
    });
  return isRight;
}

/// Whether the offsets increase from 0 to the number of ids.
template <typename Array>
bool AreOffsetsSound(Array* offsets, Array* connectivity)
{
  using Value = typename Array::ValueType;
  using Bits = std::make_unsigned_t<Value>;
  const vtkIdType last = offsets->GetNumberOfValues() - 1;
  if (last < 0 || offsets->GetValue(0) != 0 ||
    offsets->GetValue(last) != connectivity->GetNumberOfValues())
  {
    return false;
  }
  const Value* const values = offsets->GetPointer(0);
  return IsRight(last,
    [values](vtkIdType begin, vtkIdType end)
    {
      Bits wrong = 0; // neither negative nor less than the one before
      for (vtkIdType k = begin; k < end; ++k)
      {
        wrong |= static_cast<Bits>(values[k]) |
          (static_cast<Bits>(values[k + 1]) - static_cast<Bits>(values[k]));
      }
      return static_cast<Value>(wrong);
    });
}

/// Whether all ids are from 0 to less than the number of points.
template <typename Array>
bool AreIdsRight(Array* connectivity, vtkIdType numberOfPoints)
{
  using Value = typename Array::ValueType;
  using Bits = std::make_unsigned_t<Value>;
  const auto largest = static_cast<Bits>(
    std::min<vtkIdType>(numberOfPoints - 1, std::numeric_limits<Value>::max()));
  const Value* const ids = connectivity->GetPointer(0);
  const vtkIdType count = connectivity->GetNumberOfValues();
  return count == 0 ||
    (numberOfPoints > 0 &&
      IsRight(count,
        [ids, largest](vtkIdType begin, vtkIdType end)
        {
          Bits wrong = 0;
          for (vtkIdType k = begin; k < end; ++k)
          {
            wrong |= static_cast<Bits>(ids[k]) | (largest - static_cast<Bits>(ids[k]));
          }
          return static_cast<Value>(wrong);
        }));
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
  if (AreIdsRight(connectivity, numberOfPoints))
  {
    return;
  }
  const auto* const ids = connectivity->GetPointer(0);
  const auto* const wrong = std::find_if(ids, ids + connectivity->GetNumberOfValues(),
    [numberOfPoints](auto id) { return id < 0 || id >= numberOfPoints; });
  const auto* const starts = offsets->GetPointer(0);
  const auto* const next =
    std::upper_bound(starts, starts + offsets->GetNumberOfValues(), wrong - ids);
  throw Failure("its " + word + " " + std::to_string(next - starts - 1) + " names point " +
    std::to_string(*wrong) + ", which does not exist: the file has " +
    std::to_string(numberOfPoints) + " points, from 0 on; correct it in the program that " +
    "writes the file, or get a whole copy");
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
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
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
