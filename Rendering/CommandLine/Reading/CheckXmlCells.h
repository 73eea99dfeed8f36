// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief keep VTK's XML readers from lists of cells that would make them crash
 *
 * They take memory for as many point ids as the last offset says, follow the
 * numbers in the faces of polyhedra wherever they lead, and sort the nodes of
 * hexahedra from files older than version 2.1 without asking how many there
 * are. Each of these is checked between the reading of an array and its use.
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
  /// Call when an array of that name has been read. Throws Failure if it cannot be used.
  void Check(const std::string& name, vtkDataArray* values, const CheckedXmlParser& parser);

  /// Call when the types of the last cells of a grid have been read from a file whose hexahedra
  /// VTK will sort. Throws Failure if they have nodes that cannot be sorted.
  static void CheckOldHexahedra(vtkUnstructuredGrid* grid, vtkDataArray* types);

private:
  void CheckFaces(vtkDataArray* faces) const;

  vtkSmartPointer<vtkDataArray> FaceOffsets;
};

} // namespace lambent::command

#endif
