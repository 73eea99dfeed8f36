// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief sets the cells of a grid from a legacy VTK file
 */

#ifndef LegacyGrid_h
#define LegacyGrid_h

#include <vector>

class vtkCellArray;
class vtkUnstructuredGrid;

namespace lambent::command
{

/// Sets the cells of the grid. Throws Failure if the numbers of types and cells differ, a type is
/// not a byte, or the faces of a polyhedron are inconsistent.
void SetLegacyCells(vtkUnstructuredGrid* grid, vtkCellArray* cells, std::vector<int>& types);

} // namespace lambent::command

#endif
