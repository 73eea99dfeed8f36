// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the lists of cells in legacy VTK files
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

/// Reads numbers from where a reader of VTK's stands in its file, behind a keyword.
class LegacyCells
{
public:
  /// Cells may name points of this data set, if these have been read before.
  LegacyCells(vtkDataReader* reader, vtkPointSet* points, std::uint64_t fileSize)
    : Reader(reader)
    , Points(points)
    , FileSize(fileSize)
  {
  }

  /// A count that stands behind the keyword. Throws Failure if there is none, or if the file is
  /// too small for so many.
  vtkIdType ReadCount(const std::string& keyword) const;

  /// The cells behind one of the keywords of lists. Throws Failure if the list is cut short, or
  /// does not add up. What points the cells name is not looked at.
  vtkSmartPointer<vtkCellArray> ReadCells(const std::string& keyword) const;

  /// The types behind CELL_TYPES.
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
