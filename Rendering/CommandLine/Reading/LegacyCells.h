// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads the lists of cells in legacy VTK files
 */

#ifndef LegacyCells_h
#define LegacyCells_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkCellArray;
class vtkDataReader;
class vtkPointSet;

namespace lambent::command
{

/// Reads numbers from the current position of a VTK reader, after a keyword.
class LegacyCells
{
public:
  /// `points` is the data set whose points the cells name, if they have been read already.
  LegacyCells(vtkDataReader* reader, vtkPointSet* points, std::uint64_t fileSize)
    : Reader(reader)
    , Points(points)
    , FileSize(fileSize)
  {
  }

  /// Reads a count after the keyword. Throws Failure if there is none, or if the file is too small
  /// for it.
  vtkIdType ReadCount(const std::string& keyword) const;

  /// Reads the cells after a keyword. Throws Failure if the list is truncated or inconsistent. Does
  /// not reject cells that use points that do not exist.
  vtkSmartPointer<vtkCellArray> ReadCells(const std::string& keyword) const;

  /// Reads the types after CELL_TYPES.
  std::vector<int> ReadTypes() const;

private:
  vtkSmartPointer<vtkCellArray> ReadList(const std::string& keyword) const;
  vtkSmartPointer<vtkCellArray> ReadOffsets(const std::string& keyword) const;
  vtkSmartPointer<vtkCellArray> ReadInParts(vtkIdType offsets, vtkIdType ids) const;
  bool AreNextWords(const char* first, const char* second) const;
  std::size_t ReadNumbers(int* numbers, std::size_t count) const;

  vtkDataReader* Reader;
  vtkPointSet* Points;
  std::uint64_t FileSize;
};

} // namespace lambent::command

#endif
