// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LegacyCells.h"
#include "CheckCells.h"
#include "ListCheck.h"
#include "Messages.h"

#include "vtkByteSwap.h"
#include "vtkCellArray.h"
#include "vtkDataReader.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <istream>
#include <memory>

namespace lambent::command
{
namespace
{

[[noreturn]] void FailAtCell(const std::string& keyword, vtkIdType cell, vtkIdType cells)
{
  throw Failure("it is incomplete or corrupt at cell " + std::to_string(cell) + " of " +
    std::to_string(cells) + " of its " + keyword + "; use a complete copy");
}

vtkSmartPointer<vtkCellArray> ListOf(vtkDataArray* offsets, vtkDataArray* connectivity)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

/// Parses "count, ids, count, ids, ...", of which only the first `numbersRead` have been read.
vtkSmartPointer<vtkCellArray> CellsOf(const std::string& keyword, vtkIdType cells,
  const int* numbers, vtkIdType size, vtkIdType numbersRead, ListCheck check)
{
  if (cells > size)
  {
    FailAtCell(keyword, size, cells);
  }
  const vtkIdType ids = size - cells;
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> connectivity;
  offsets->SetNumberOfValues(cells + 1);
  connectivity->SetNumberOfValues(ids);
  vtkIdType seen = 0;
  const auto look = [&](vtkIdType end)
  {
    check.LookAtIds(connectivity, seen, end);
    seen = end;
  };
  vtkTypeInt64* const to = connectivity->GetPointer(0);
  vtkIdType at = 0;
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const vtkIdType first = at - cell; // each cell before this one has a number that is not an id
    offsets->SetValue(cell, first);
    const vtkIdType count = at < numbersRead ? numbers[at] : -1;
    if (count < 0 || count > numbersRead - at - 1 || count > ids - first)
    {
      FailAtCell(keyword, cell, cells);
    }
    ++at;
    std::copy(numbers + at, numbers + at + count, to + first);
    at += count;
    if (first + count - seen >= ListCheck::Part)
    {
      look(first + count);
    }
  }
  if (at != size)
  {
    throw Failure("the list of its " + std::to_string(cells) + " " + keyword + " has " +
      std::to_string(at) + " numbers, but its first line declares " + std::to_string(size) +
      "; correct that line, or use a complete copy");
  }
  offsets->SetValue(cells, ids);
  look(ids);
  check.LookAtOffsets(offsets, 1, cells + 1);
  const auto result = ListOf(offsets, connectivity);
  check.Note(result);
  return result;
}

/// Reads values from the next line on, and calls `look` for each part.
template <typename Look>
bool ReadParts(std::istream& stream, vtkTypeInt64Array* array, vtkIdType count, const Look& look)
{
  array->SetNumberOfValues(count);
  std::string restOfLine;
  std::getline(stream, restOfLine);
  for (vtkIdType begin = 0; begin < count; begin += ListCheck::Part)
  {
    const vtkIdType end = std::min(begin + ListCheck::Part, count);
    vtkTypeInt64* const values = array->GetPointer(begin);
    if (!stream.read(reinterpret_cast<char*>(values),
          static_cast<std::streamsize>(sizeof(*values)) * (end - begin)))
    {
      return false;
    }
    vtkByteSwap::Swap8BERange(values, static_cast<std::size_t>(end - begin));
    look(begin, end);
  }
  return true;
}

} // namespace

vtkIdType LegacyCells::ReadCount(const std::string& keyword) const
{
  vtkIdType count = 0;
  if (!this->Reader->Read(&count))
  {
    throw Failure("it is incomplete or corrupt: no count follows its keyword " + keyword +
      "; use a complete copy");
  }
  if (count < 0 || static_cast<std::uint64_t>(count) > this->FileSize)
  {
    throw Failure("it is incomplete or corrupt: it is too small for the count of " +
      std::to_string(count) + " after its keyword " + keyword + "; use a complete copy");
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
  const std::unique_ptr<int[]> numbers(new int[count]); // make_unique would fill it with zeros
  const std::size_t numbersRead = this->ReadNumbers(numbers.get(), count);
  return CellsOf(keyword, cells, numbers.get(), size, static_cast<vtkIdType>(numbersRead),
    ListCheck(this->Points->GetNumberOfPoints()));
}

bool LegacyCells::AreNextWords(const char* first, const char* second) const
{
  for (const char* const expected : { first, second })
  {
    char word[256];
    if (!this->Reader->ReadString(word) || std::string(this->Reader->LowerCase(word)) != expected)
    {
      return false;
    }
  }
  return true;
}

/// Returns null unless these are arrays of a binary file as VTK writes them.
vtkSmartPointer<vtkCellArray> LegacyCells::ReadInParts(vtkIdType offsets, vtkIdType ids) const
{
  std::istream& stream = *this->Reader->GetIStream();
  vtkNew<vtkTypeInt64Array> starts;
  vtkNew<vtkTypeInt64Array> connectivity;
  ListCheck check(this->Points->GetNumberOfPoints());
  const auto lookAtStarts = [&](vtkIdType begin, vtkIdType end)
  { check.LookAtOffsets(starts, std::max<vtkIdType>(begin, 1), end); };
  const auto lookAtIds = [&](vtkIdType begin, vtkIdType end)
  { check.LookAtIds(connectivity, begin, end); };
  if (this->Reader->GetFileType() != VTK_BINARY || offsets < 1 || ids < 1 ||
    !this->AreNextWords("offsets", "vtktypeint64") ||
    !ReadParts(stream, starts, offsets, lookAtStarts) ||
    !this->AreNextWords("connectivity", "vtktypeint64") ||
    !ReadParts(stream, connectivity, ids, lookAtIds))
  {
    return nullptr;
  }
  const std::istream::pos_type end = stream.tellg();
  char word[256];
  const bool hasMetadata =
    this->Reader->ReadString(word) && std::string(this->Reader->LowerCase(word)) == "metadata";
  stream.clear();
  stream.seekg(end);
  if (hasMetadata)
  {
    return nullptr;
  }
  auto cells = ListOf(starts, connectivity);
  check.Note(cells);
  return cells;
}

/// Reads the arrays of offsets and ids that files have from version 5 on.
vtkSmartPointer<vtkCellArray> LegacyCells::ReadOffsets(const std::string& keyword) const
{
  std::istream& stream = *this->Reader->GetIStream();
  const std::istream::pos_type start = stream.tellg();
  const vtkIdType offsets = this->ReadCount(keyword);
  const vtkIdType ids = this->ReadCount(keyword);
  vtkSmartPointer<vtkCellArray> cells = this->ReadInParts(offsets, ids);
  if (!cells)
  {
    stream.clear();
    stream.seekg(start); // VTK reads the other variants
    if (!this->Reader->ReadCells(cells) || !cells)
    {
      throw Failure("it is incomplete or corrupt in its " + keyword + "; use a complete copy");
    }
  }
  if (!AreIdsKnownBelow(cells, this->Points->GetNumberOfPoints()))
  {
    CheckOffsets(cells);
  }
  return cells;
}

std::vector<int> LegacyCells::ReadTypes() const
{
  std::vector<int> types(static_cast<std::size_t>(this->ReadCount("CELL_TYPES")));
  if (this->ReadNumbers(types.data(), types.size()) != types.size())
  {
    throw Failure("it is incomplete or corrupt in its CELL_TYPES; use a complete copy");
  }
  return types;
}

} // namespace lambent::command
