// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief rejects lists of cells that would crash VTK's XML readers
 *
 * The readers allocate memory for as many point ids as the last offset says, follow the counts in
 * the faces of polyhedra without bounds checks, and sort the nodes of hexahedra from files older
 * than version 2.1 without checking how many there are. Each of these is checked after an array has
 * been read and before it is used.
 */

#ifndef CheckXmlCells_h
#define CheckXmlCells_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataArray;
class vtkUnstructuredGrid;

namespace lambent::command
{

class CheckedXmlParser;

class XmlCellsCheck
{
public:
  /// Call after an array of that name has been read. Throws Failure if it is invalid.
  void Check(const std::string& name, vtkDataArray* values, const CheckedXmlParser& parser);

  /// Call after the types of the last cells of a grid have been read from a file whose hexahedra
  /// VTK will sort. Throws Failure if their nodes cannot be sorted.
  static void CheckOldHexahedra(vtkUnstructuredGrid* grid, vtkDataArray* types);

private:
  void CheckFaces(vtkDataArray* faces) const;

  vtkSmartPointer<vtkDataArray> FaceOffsets;
};

} // namespace lambent::command

#endif
