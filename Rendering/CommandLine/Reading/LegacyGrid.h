// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the cells and types of a legacy VTK file as those of a grid
 */

#ifndef LegacyGrid_h
#define LegacyGrid_h

#include <vector>

class vtkCellArray;
class vtkUnstructuredGrid;

namespace lambent::command
{

/// Sets the cells of the grid. Throws Failure if there are not as many types as cells, a type is
/// not a byte, or the faces of a polyhedron do not add up.
void SetLegacyCells(vtkUnstructuredGrid* grid, vtkCellArray* cells, std::vector<int>& types);

} // namespace lambent::command

#endif
