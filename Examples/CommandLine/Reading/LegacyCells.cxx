// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LegacyCells.h"
#include "CheckCells.h"
#include "HigherOrder.h"
#include "Messages.h"

#include "vtkByteSwap.h"
#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataReader.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnstructuredGrid.h"

#include <istream>
#include <memory>

namespace lambent::command
{
namespace
{

[[noreturn]] void FailAtCell(const std::string& keyword, vtkIdType cell, vtkIdType cells)
{
  throw Failure("it is cut short or broken at cell " + std::to_string(cell) + " of " +
    std::to_string(cells) + " of its " + keyword + "; get a whole copy of it");
}

/// Goes through "count, ids, count, ids, ...", of which only the first ones have been read.
vtkSmartPointer<vtkCellArray> CellsOf(const std::string& keyword, vtkIdType cells,
  const int* numbers, vtkIdType size, vtkIdType numbersRead)
{
  if (cells > size)
  {
    FailAtCell(keyword, size, cells);
  }
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> connectivity;
  offsets->SetNumberOfValues(cells + 1);
  connectivity->SetNumberOfValues(size - cells);
  vtkTypeInt64* const starts = offsets->GetPointer(0);
  vtkTypeInt64* const ids = connectivity->GetPointer(0);
  vtkIdType at = 0;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const vtkIdType before = at - cell; // each cell before has one number that is not an id
    starts[cell] = before;
    const vtkIdType count = at < numbersRead ? numbers[at] : -1;
    // Enough numbers stay for the counts of the other cells, so that `ids` is not overrun.
    if (count < 0 || count > numbersRead - at - 1 || before + count > size - cells)
    {
      FailAtCell(keyword, cell, cells);
    }
    ++at;
    for (vtkIdType k = 0; k < count; ++k)
    {
      ids[before + k] = numbers[at + k];
    }
    at += count;
  }
  if (at != size)
  {
    throw Failure("the list of its " + std::to_string(cells) + " " + keyword + " has " +
      std::to_string(at) + " numbers, and its first line says " + std::to_string(size) +
      "; correct that line, or get a whole copy");
  }
  starts[cells] = size - cells;
  auto result = vtkSmartPointer<vtkCellArray>::New();
  vtkDataArray* const asOffsets = offsets; // the functions for other types differ by VTK's version
  vtkDataArray* const asConnectivity = connectivity;
  result->SetData(asOffsets, asConnectivity);
  return result;
}

/// The points of a polyhedron are "faces, points of a face, ids, points of a face, ids, ...".
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

vtkIdType LegacyCells::ReadCount(const std::string& keyword) const
{
  vtkIdType count = 0;
  if (!this->Reader->Read(&count))
  {
    throw Failure("it is cut short or broken: no count follows its keyword " + keyword +
      "; get a whole copy of it");
  }
  if (count < 0 || static_cast<std::uint64_t>(count) > this->FileSize)
  {
    throw Failure("it is cut short or broken: it is too small for the count of " +
      std::to_string(count) + " behind its keyword " + keyword + "; get a whole copy of it");
  }
  return count;
}

vtkSmartPointer<vtkCellArray> LegacyCells::ReadCells(const std::string& keyword) const
{
  return this->Reader->GetFileMajorVersion() >= 5 ? this->ReadOffsets(keyword)
                                                  : this->ReadList(keyword);
}

std::size_t LegacyCells::ReadNumbers(int* numbers, std::size_t count) const
{
  if (this->Reader->GetFileType() == VTK_BINARY)
  {
    std::istream& stream = *this->Reader->GetIStream();
    std::string restOfLine;
    std::getline(stream, restOfLine);
    stream.read(reinterpret_cast<char*>(numbers), static_cast<std::streamsize>(4 * count));
    const std::size_t numbersRead = static_cast<std::size_t>(stream.gcount()) / 4;
    vtkByteSwap::Swap4BERange(numbers, numbersRead);
    return numbersRead;
  }
  std::size_t numbersRead = 0;
  while (numbersRead < count && this->Reader->Read(numbers + numbersRead))
  {
    ++numbersRead;
  }
  return numbersRead;
}

vtkSmartPointer<vtkCellArray> LegacyCells::ReadList(const std::string& keyword) const
{
  const vtkIdType cells = this->ReadCount(keyword);
  const vtkIdType size = this->ReadCount(keyword);
  const auto count = static_cast<std::size_t>(size);
  const std::unique_ptr<int[]> numbers(new int[count]); // not make_unique: it would fill them
  const std::size_t numbersRead = this->ReadNumbers(numbers.get(), count);
  return CellsOf(keyword, cells, numbers.get(), size, static_cast<vtkIdType>(numbersRead));
}

/// From version 5 on, arrays of offsets and of ids. Their sizes are read once more by VTK.
vtkSmartPointer<vtkCellArray> LegacyCells::ReadOffsets(const std::string& keyword) const
{
  std::istream& stream = *this->Reader->GetIStream();
  const std::istream::pos_type start = stream.tellg();
  this->ReadCount(keyword);
  this->ReadCount(keyword);
  stream.clear();
  stream.seekg(start);
  vtkSmartPointer<vtkCellArray> cells;
  if (!this->Reader->ReadCells(cells) || !cells)
  {
    throw Failure("it is cut short or broken in its " + keyword + "; get a whole copy of it");
  }
  CheckOffsets(cells);
  return cells;
}

std::vector<int> LegacyCells::ReadTypes() const
{
  std::vector<int> types(static_cast<std::size_t>(this->ReadCount("CELL_TYPES")));
  if (this->ReadNumbers(types.data(), types.size()) != types.size())
  {
    throw Failure("it is cut short or broken in its CELL_TYPES; get a whole copy of it");
  }
  return types;
}

void SetLegacyCells(vtkUnstructuredGrid* grid, vtkCellArray* cells, std::vector<int>& types)
{
  const vtkIdType count = cells->GetNumberOfCells();
  if (static_cast<vtkIdType>(types.size()) != count)
  {
    throw Failure("it has " + std::to_string(count) + " CELLS and " +
      std::to_string(types.size()) + " CELL_TYPES; get a whole copy of it");
  }
  vtkNew<vtkIdList> stream;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    const int type = types[static_cast<std::size_t>(cell)];
    if (type < 0 || type > 255)
    {
      throw Failure("its cell " + std::to_string(cell) + " is of type " + std::to_string(type) +
        ", and there is no such type" + CorrectCell);
    }
    if (type == VTK_POLYHEDRON)
    {
      cells->GetCellAtId(cell, stream);
      if (!IsStreamOfFaces(stream->GetNumberOfIds(), stream->GetPointer(0)))
      {
        throw Failure("it is broken: the faces of its cell " + std::to_string(cell) +
          " do not add up; get a whole copy of it");
      }
    }
  }
  grid->SetCells(types.data(), cells);
}

} // namespace lambent::command
