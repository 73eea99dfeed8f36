// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's readers of legacy files, with checks of the cells
 *
 * Up to version 4 of the format, cells are a list of numbers, "count, ids, count, ids, ...", whose
 * length is given in the keyword's line. VTK's readers of polygons and unstructured grids allocate
 * any length, accept a list even if the file ends within it, follow counts that were never read,
 * and read as many types as there are cells. These readers use the same VTK functions for the other
 * parts but check each list before it is used. They convert the list to cells in one pass, which is
 * faster than VTK's three.
 */

#ifndef ReadLegacyVtk_h
#define ReadLegacyVtk_h

#include "CheckedReader.h"

#include "vtkPolyDataReader.h"
#include "vtkUnstructuredGridReader.h"

#include <string>

namespace lambent::command
{

/// The type of data in a legacy file.
enum class LegacyType
{
  PolyData,
  UnstructuredGrid,
  Other ///< has no lists of cells, or is not a legacy file, which VTK's reader reports
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
