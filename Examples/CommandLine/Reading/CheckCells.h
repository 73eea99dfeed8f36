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

/// Throws Failure unless every cell names points that exist.
void CheckCells(vtkCellArray* cells, vtkIdType numberOfPoints);

/// Also unless each is of a type that VTK knows, and has as many points as that type has. How the
/// faces of polyhedra and the nodes of cells of any order are laid out is not looked at.
void CheckCells(vtkUnstructuredGrid* grid);

} // namespace lambent::command

#endif
