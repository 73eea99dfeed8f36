// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief checks cells read from a file
 *
 * Code that uses cells relies on their point ids and their number of points, but a file may hold
 * any values.
 */

#ifndef CheckCells_h
#define CheckCells_h

#include "vtkType.h"

class vtkCellArray;
class vtkUnstructuredGrid;

namespace lambent::command
{

/// Throws Failure unless the offsets of the cells increase from 0 to the number of point ids.
void CheckOffsets(vtkCellArray* cells, const char* word = "cell");

/// Also requires that every cell names existing points. The message calls a cell `word`.
void CheckCells(vtkCellArray* cells, vtkIdType numberOfPoints, const char* word = "cell");

/// Also requires that every cell has a type known to VTK and the number of points of that type, and
/// that the faces of polyhedra are valid.
void CheckCells(vtkUnstructuredGrid* grid);

} // namespace lambent::command

#endif
