// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief converts higher-order cells to linear cells
 *
 * The nodes of a Lagrange cell of order n form a lattice with n steps along each side. The cell is
 * divided into the linear cells of the lattice: n^2 triangles or quadrilaterals, or n^3 tetrahedra,
 * wedges or hexahedra. Neighbours share the nodes between them, so their surfaces match and inner
 * faces vanish as between linear cells. An octahedron in the lattice of a tetrahedron becomes four
 * tetrahedra around one of its diagonals.
 *
 * Other cells become the linear cell of their corners: pyramids, Bezier cells, whose inner nodes
 * are not on the surface, and the types 60 to 67, whose nodes have no defined order.
 *
 * The result depends only on the file. VTK's own conversion differs between versions and crashes on
 * some cells.
 */

#ifndef LinearCells_h
#define LinearCells_h

#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

namespace lambent::command
{

/// Returns the grid itself if it has no cell of the types 60 to 81, or if an array is too short.
/// Otherwise returns a grid with linear cells instead, on the same points. The cells must have
/// passed CheckCells().
vtkSmartPointer<vtkUnstructuredGrid> WithLinearCells(vtkUnstructuredGrid* grid);

} // namespace lambent::command

#endif
