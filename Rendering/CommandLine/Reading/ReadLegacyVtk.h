// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's readers of legacy files with checks of the cells
 *
 * Up to version 4 of the format the cells are one list of numbers, "count, ids,
 * count, ids, ...", of a length that the keyword's line gives. VTK's readers of
 * polygons and of unstructured grids allocate whatever that length is, take the
 * list for whole also where the file ends within it, go through counts that
 * nobody has written, and read as many types as there are cells. These readers
 * have the same parts, in VTK's own functions, and check each list before it is
 * used; the list becomes cells in one pass, which is faster than VTK's three.
 */

#ifndef ReadLegacyVtk_h
#define ReadLegacyVtk_h

#include "CheckedReader.h"

#include "vtkPolyDataReader.h"
#include "vtkUnstructuredGridReader.h"

#include <string>

namespace lambent::command
{

/// What a legacy file holds.
enum class LegacyType
{
  PolyData,
  UnstructuredGrid,
  Other ///< which has no lists of cells; or is no such file, which a reader of VTK's says
};
LegacyType LegacyTypeOf(const std::string& path);

class LegacyPolyDataReader
  : public vtkPolyDataReader
  , public CheckedReader
{
public:
  static LegacyPolyDataReader* New();
  vtkTypeMacro(LegacyPolyDataReader, vtkPolyDataReader)

  int ReadMeshSimple(const std::string& path, vtkDataObject* output) override;
};

class LegacyGridReader
  : public vtkUnstructuredGridReader
  , public CheckedReader
{
public:
  static LegacyGridReader* New();
  vtkTypeMacro(LegacyGridReader, vtkUnstructuredGridReader)

  int ReadMeshSimple(const std::string& path, vtkDataObject* output) override;
};

} // namespace lambent::command

#endif
