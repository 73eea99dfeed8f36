// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief whether the cells that were read can be worked with
 *
 * Whoever uses cells relies on their point ids and on their number of points;
 * those that come from a file may be anything.
 */

#ifndef CheckCells_h
#define CheckCells_h

#include "vtkType.h"

class vtkCellArray;
class vtkUnstructuredGrid;

namespace lambent::command
{

/// Throws Failure unless the points of each cell are a part of the list of ids.
void CheckOffsets(vtkCellArray* cells, const char* word = "cell");

/// Also unless every cell names points that exist. The message calls a cell by `word`.
void CheckCells(vtkCellArray* cells, vtkIdType numberOfPoints, const char* word = "cell");

/// Also unless each is of a type that VTK knows, and has as many points as that type has, and the
/// faces of each polyhedron are whole.
void CheckCells(vtkUnstructuredGrid* grid);

} // namespace lambent::command

#endif
