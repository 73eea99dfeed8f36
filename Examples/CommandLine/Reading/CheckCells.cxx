// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckCells.h"
#include "CheckFaces.h"
#include "HigherOrder.h"
#include "Messages.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt64Array.h"
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

/// Calls visit with the values of an array of offsets or ids.
template <typename Visit>
auto VisitValues(vtkDataArray* array, const Visit& visit)
{
  if (auto* const small = vtkAOSDataArrayTemplate<vtkTypeInt32>::FastDownCast(array))
  {
    return visit(small->GetPointer(0));
  }
  auto* large = vtkAOSDataArrayTemplate<vtkTypeInt64>::FastDownCast(array);
  vtkNew<vtkTypeInt64Array> copy;
  if (!large) // newer versions of VTK have arrays that are formulas
  {
    copy->DeepCopy(array);
    large = copy;
  }
  return visit(large->GetPointer(0));
}

/// Whether wrong(begin, end) has no highest bit for all parts of the range: a sum of bits, of which
/// the processor takes many numbers at once, so that this is as fast as memory.
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

/// Whether these are not negative, and none is less than the one before.
template <typename Value>
bool Increase(const Value* values, vtkIdType count)
{
  using Bits = std::make_unsigned_t<Value>;
  return IsRight(count - 1,
    [values](vtkIdType begin, vtkIdType end)
    {
      Bits wrong = 0;
      for (vtkIdType k = begin; k < end; ++k)
      {
        wrong |= static_cast<Bits>(values[k]) |
          (static_cast<Bits>(values[k + 1]) - static_cast<Bits>(values[k]));
      }
      return static_cast<Value>(wrong);
    });
}

/// Whether all ids are from 0 to less than the number of points.
template <typename Value>
bool AreIdsRight(const Value* ids, vtkIdType count, vtkIdType numberOfPoints)
{
  using Bits = std::make_unsigned_t<Value>;
  if (count == 0 || numberOfPoints == 0)
  {
    return count == 0;
  }
  const auto largest = static_cast<Bits>(
    std::min<vtkIdType>(numberOfPoints - 1, std::numeric_limits<Value>::max()));
  return IsRight(count,
    [ids, largest](vtkIdType begin, vtkIdType end)
    {
      Bits wrong = 0;
      for (vtkIdType k = begin; k < end; ++k)
      {
        wrong |= static_cast<Bits>(ids[k]) | (largest - static_cast<Bits>(ids[k]));
      }
      return static_cast<Value>(wrong);
    });
}

[[noreturn]] void FailForPoint(
  vtkCellArray* cells, vtkIdType at, vtkIdType id, vtkIdType numberOfPoints, const char* word)
{
  const vtkIdType offsets = cells->GetNumberOfCells() + 1;
  const vtkIdType cell = VisitValues(cells->GetOffsetsArray(),
    [offsets, at](const auto* starts) -> vtkIdType
    { return std::upper_bound(starts, starts + offsets, at) - starts - 1; });
  throw Failure("its " + std::string(word) + " " + std::to_string(cell) + " names point " +
    std::to_string(id) + ", which does not exist: the file has " +
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

} // namespace

void CheckOffsets(vtkCellArray* cells, const char* word)
{
  vtkDataArray* const offsets = cells->GetOffsetsArray();
  const vtkIdType count = offsets->GetNumberOfTuples();
  const vtkIdType ids = cells->GetConnectivityArray()->GetNumberOfTuples();
  const bool isSound = count > 0 &&
    VisitValues(offsets,
      [count, ids](const auto* values)
      { return values[0] == 0 && values[count - 1] == ids && Increase(values, count); });
  if (!isSound)
  {
    throw Failure("it is broken: where each " + std::string(word) +
      " begins in the list of their points does not add up; get a whole copy of it");
  }
}

void CheckCells(vtkCellArray* cells, vtkIdType numberOfPoints, const char* word)
{
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  CheckOffsets(cells, word);
  vtkDataArray* const connectivity = cells->GetConnectivityArray();
  const vtkIdType count = connectivity->GetNumberOfTuples();
  VisitValues(connectivity,
    [=](const auto* ids)
    {
      if (!AreIdsRight(ids, count, numberOfPoints))
      {
        const auto* const wrong = std::find_if(ids, ids + count,
          [numberOfPoints](auto id) { return id < 0 || id >= numberOfPoints; });
        FailForPoint(cells, wrong - ids, *wrong, numberOfPoints, word);
      }
    });
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
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
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
