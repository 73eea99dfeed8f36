// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief run a reader of the command on a file with given bytes
 */
#ifndef ReadFrom_h
#define ReadFrom_h

#include "BrokenFiles.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

/// Rows of the values of an array, and the points of each cell.
using Rows = std::vector<std::vector<double>>;
using Cells = std::vector<std::vector<vtkIdType>>;

struct Outcome
{
  vtkSmartPointer<vtkPolyData> mesh; ///< null if the reader failed
  std::string failure;
  std::string warnings; ///< one per line
};

/// Calls read(path, progress) with a file of these bytes. Expects point data of the right length.
template <typename Reader>
Outcome ReadFrom(Reader&& read, const std::string& bytes)
{
  const Scratch scratch(".mesh");
  scratch.write(bytes);
  lambent::command::VtkMessages messages(true);
  Outcome outcome;
  try
  {
    outcome.mesh = read(scratch.path, [](double) {});
    for (int i = 0; i < outcome.mesh->GetPointData()->GetNumberOfArrays(); ++i)
    {
      EXPECT_EQ(outcome.mesh->GetPointData()->GetArray(i)->GetNumberOfTuples(),
        outcome.mesh->GetNumberOfPoints());
    }
  }
  catch (const lambent::command::Failure& failure)
  {
    outcome.failure = failure.what();
  }
  testing::internal::CaptureStderr();
  messages.FlushWarnings("");
  outcome.warnings = testing::internal::GetCapturedStderr();
  return outcome;
}

inline Rows RowsOf(vtkDataArray* array)
{
  Rows rows;
  for (vtkIdType k = 0; array && k < array->GetNumberOfTuples(); ++k)
  {
    const double* const tuple = array->GetTuple(k);
    rows.emplace_back(tuple, tuple + array->GetNumberOfComponents());
  }
  return rows;
}

inline Rows PointsOf(const Outcome& outcome)
{
  return RowsOf(outcome.mesh ? outcome.mesh->GetPoints()->GetData() : nullptr);
}

inline Rows NormalsOf(const Outcome& outcome)
{
  return RowsOf(outcome.mesh ? outcome.mesh->GetPointData()->GetNormals() : nullptr);
}

inline Cells CellsOf(vtkCellArray* array)
{
  Cells cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < array->GetNumberOfCells(); ++cell)
  {
    array->GetCellAtId(cell, ids);
    cells.emplace_back(ids->begin(), ids->end());
  }
  return cells;
}

inline Cells PolygonsOf(const Outcome& outcome)
{
  return outcome.mesh ? CellsOf(outcome.mesh->GetPolys()) : Cells();
}

#endif
