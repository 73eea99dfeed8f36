// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckCells.h"
#include "CheckFaces.h"
#include "HigherOrder.h"
#include "IdArrays.h"
#include "ListCheck.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkGenericCell.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <string>

namespace lambent::command
{
namespace
{

/// Whether isRight(begin, end) holds for all parts of a range. The parts run in parallel.
template <typename Check>
bool IsRight(vtkIdType count, const Check& isRight)
{
  std::atomic<bool> all{ true };
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      if (!isRight(begin, end))
      {
        all = false;
      }
    });
  return all;
}

/// Whether offsets[0 .. last] increase from 0 to the number of ids.
template <typename Value>
bool AreOffsetsSound(const Value* offsets, vtkIdType last, vtkIdType ids)
{
  return offsets[0] == 0 && offsets[last] == ids &&
    IsRight(
      last, [offsets](vtkIdType begin, vtkIdType end) { return DoIncrease(offsets, begin, end); });
}

/// Whether all ids are in [0, numberOfPoints).
template <typename Value>
bool AreIdsSound(const Value* ids, vtkIdType count, vtkIdType numberOfPoints)
{
  return count == 0 ||
    (numberOfPoints > 0 &&
      IsRight(count,
        [ids, numberOfPoints](vtkIdType begin, vtkIdType end)
        { return AreIdsBelow(numberOfPoints, ids, begin, end); }));
}

[[noreturn]] void FailForPoint(
  vtkCellArray* cells, vtkIdType at, vtkIdType id, vtkIdType numberOfPoints, const char* word)
{
  const vtkIdType offsets = cells->GetNumberOfCells() + 1;
  vtkIdType cell = 0;
  VisitValues(cells->GetOffsetsArray(),
    [&cell, offsets, at](const auto* starts)
    { cell = std::upper_bound(starts, starts + offsets, at) - starts - 1; });
  throw Failure("its " + std::string(word) + " " + std::to_string(cell) + " uses point " +
    std::to_string(id) + ", which does not exist: the file has " + std::to_string(numberOfPoints) +
    " points, numbered from 0; correct it in the program that writes the file, or use a complete "
    "copy");
}

/// The number of points that a type of cell must have.
struct Points
{
  bool IsKnown = false;  ///< VTK has this type
  vtkIdType Exactly = 0; ///< the exact number; 0: any
  bool IsEven = false;   ///< as many mid-edge nodes as corners
  bool IsLooked = false; ///< this entry has been filled in
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
      " points, but there is no such type" + CorrectCell);
  }
  if (points.Exactly > 0 && points.Exactly != count)
  {
    throw Failure(CellWithType(cell, type) + " has " + std::to_string(count) +
      " points instead of " + std::to_string(points.Exactly) + CorrectCell);
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
  bool isSound = false;
  if (count > 0)
  {
    VisitValues(offsets,
      [&isSound, count, ids](const auto* values)
      { isSound = AreOffsetsSound(values, count - 1, ids); });
  }
  if (!isSound)
  {
    throw Failure(
      "it is corrupt: its " + std::string(word) + " offsets are inconsistent; use a complete copy");
  }
}

void CheckCells(vtkCellArray* cells, vtkIdType numberOfPoints, const char* word)
{
  if (!cells || cells->GetNumberOfCells() == 0 || AreIdsKnownBelow(cells, numberOfPoints))
  {
    return;
  }
  CheckOffsets(cells, word);
  vtkDataArray* const connectivity = cells->GetConnectivityArray();
  const vtkIdType count = connectivity->GetNumberOfTuples();
  VisitValues(connectivity,
    [=](const auto* ids)
    {
      if (!AreIdsSound(ids, count, numberOfPoints))
      {
        const auto* const wrong = std::find_if(
          ids, ids + count, [numberOfPoints](auto id) { return id < 0 || id >= numberOfPoints; });
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
