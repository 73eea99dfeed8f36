// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadLegacyVtk.h"
#include "HigherOrder.h"
#include "LegacyCells.h"
#include "LegacyGrid.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUpdateCellsV8toV9.h"

#include <filesystem>

namespace lambent::command
{
namespace
{

bool StartsWith(const std::string& text, const char* start)
{
  return text.rfind(start, 0) == 0;
}

/// The next word, in lower case; empty at the end of the file.
std::string NextWord(vtkDataReader* reader)
{
  char word[256];
  return reader->ReadString(word) ? reader->LowerCase(word) : "";
}

/// Reads the parts of a data set in order.
class Parts
{
public:
  Parts(vtkDataReader* reader, vtkPointSet* output, const std::string& path)
    : Reader(reader)
    , Output(output)
    , Lists(reader, output, std::filesystem::file_size(path))
  {
  }

  const LegacyCells& GetLists() const { return this->Lists; }

  /// Calls readList(keyword) for each keyword that is not common to all types of data; it must
  /// return whether it knows the keyword. Then calls finish() and reads the point and cell data.
  template <typename ReadList, typename Finish>
  void Read(const ReadList& readList, const Finish& finish)
  {
    NextWord(this->Reader); // skip "dataset" and its type
    NextWord(this->Reader);
    std::string word = NextWord(this->Reader);
    for (; !word.empty() && !IsData(word); word = NextWord(this->Reader))
    {
      if (!this->ReadCommon(word) && !readList(word))
      {
        throw Failure("it has '" + word +
          "' where a keyword such as POINTS is expected; correct it in the program that writes "
          "the file, or use a complete copy");
      }
    }
    finish();
    this->ReadData(word);
  }

private:
  static bool IsData(const std::string& word)
  {
    return StartsWith(word, "cell_data") || StartsWith(word, "point_data");
  }

  bool ReadCommon(const std::string& word)
  {
    if (StartsWith(word, "points"))
    {
      const vtkIdType count = this->Lists.ReadCount("POINTS");
      if (!this->Reader->ReadPointCoordinates(this->Output, count))
      {
        throw Failure("it is incomplete or corrupt in its " + std::to_string(count) +
          " POINTS; use a complete copy");
      }
      return true;
    }
    if (StartsWith(word, "field"))
    {
      const auto field = vtkSmartPointer<vtkFieldData>::Take(this->Reader->ReadFieldData());
      if (!field)
      {
        throw Failure("it is incomplete or corrupt in its FIELD; use a complete copy");
      }
      this->Output->SetFieldData(field);
      return true;
    }
    return false;
  }

  /// VTK's functions read both point and cell data, whichever comes first.
  void ReadData(const std::string& word)
  {
    if (StartsWith(word, "cell_data"))
    {
      const vtkIdType count = this->Lists.ReadCount("CELL_DATA");
      CheckCount("CELL_DATA", count, this->Output->GetNumberOfCells(), " cells");
      this->Reader->ReadCellData(this->Output, count);
    }
    else if (StartsWith(word, "point_data"))
    {
      const vtkIdType count = this->Lists.ReadCount("POINT_DATA");
      CheckCount("POINT_DATA", count, this->Output->GetNumberOfPoints(), " points");
      this->Reader->ReadPointData(this->Output, count);
    }
  }

  static void CheckCount(
    const std::string& keyword, vtkIdType count, vtkIdType expected, const char* what)
  {
    if (count != expected)
    {
      throw Failure("it has " + keyword + " for " + std::to_string(count) + what + ", but " +
        std::to_string(expected) + what +
        "; correct the count in the program that writes the "
        "file, or use a complete copy");
    }
  }

  vtkDataReader* Reader;
  vtkPointSet* Output;
  LegacyCells Lists;
};

/// Up to version 5.0, the nodes of higher-order hexahedra are in a different order.
void SortNodes(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    const int type = grid->GetCellType(cell);
    if (IsSortedHexahedron(type))
    {
      CheckHigherOrder(grid, cell, type);
    }
  }
  vtkUpdateCellsV8toV9(grid);
}

void ReadPolyData(vtkDataReader* reader, vtkPolyData* mesh, const std::string& path)
{
  Parts parts(reader, mesh, path);
  const auto readList = [&parts, mesh](const std::string& word)
  {
    if (StartsWith(word, "vertices"))
    {
      mesh->SetVerts(parts.GetLists().ReadCells("VERTICES"));
    }
    else if (StartsWith(word, "lines"))
    {
      mesh->SetLines(parts.GetLists().ReadCells("LINES"));
    }
    else if (StartsWith(word, "polygons"))
    {
      mesh->SetPolys(parts.GetLists().ReadCells("POLYGONS"));
    }
    else if (StartsWith(word, "triangle_strips"))
    {
      mesh->SetStrips(parts.GetLists().ReadCells("TRIANGLE_STRIPS"));
    }
    else
    {
      return false;
    }
    return true;
  };
  parts.Read(readList, [] {});
}

void ReadGrid(vtkDataReader* reader, vtkUnstructuredGrid* grid, const std::string& path)
{
  Parts parts(reader, grid, path);
  vtkSmartPointer<vtkCellArray> cells;
  std::vector<int> types;
  const auto readList = [&](const std::string& word)
  {
    if (StartsWith(word, "cells"))
    {
      cells = parts.GetLists().ReadCells("CELLS");
    }
    else if (StartsWith(word, "cell_types"))
    {
      types = parts.GetLists().ReadTypes();
    }
    else
    {
      return false;
    }
    return true;
  };
  const auto finish = [&]
  {
    if (cells)
    {
      SetLegacyCells(grid, cells, types);
    }
  };
  parts.Read(readList, finish);
  if (cells && 10 * reader->GetFileMajorVersion() + reader->GetFileMinorVersion() < 51)
  {
    SortNodes(grid);
  }
}

} // namespace

LegacyType LegacyTypeOf(const std::string& path)
{
  vtkNew<vtkGenericDataObjectReader> reader;
  reader->SetFileName(path.c_str());
  switch (reader->ReadOutputType())
  {
    case VTK_POLY_DATA:
      return LegacyType::PolyData;
    case VTK_UNSTRUCTURED_GRID:
      return LegacyType::UnstructuredGrid;
    default:
      return LegacyType::Other;
  }
}

vtkStandardNewMacro(LegacyPolyDataReader);
vtkStandardNewMacro(LegacyGridReader);

int LegacyPolyDataReader::ReadMeshSimple(const std::string& path, vtkDataObject* output)
{
  auto* const mesh = vtkPolyData::SafeDownCast(output);
  if (this->OpenVTKFile(path.c_str()) && this->ReadHeader(path.c_str()))
  {
    this->Passes([&] { ReadPolyData(this, mesh, path); });
  }
  this->CloseVTKFile();
  return 1;
}

int LegacyGridReader::ReadMeshSimple(const std::string& path, vtkDataObject* output)
{
  auto* const grid = vtkUnstructuredGrid::SafeDownCast(output);
  if (this->OpenVTKFile(path.c_str()) && this->ReadHeader(path.c_str()))
  {
    this->Passes([&] { ReadGrid(this, grid, path); });
  }
  this->CloseVTKFile();
  return 1;
}

} // namespace lambent::command
