// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief cells of any order as linear cells
 *
 * A Lagrange cell of order n has nodes on a lattice with n steps to each side;
 * it becomes the linear cells between them, n^2 triangles or quadrilaterals and
 * n^3 tetrahedra, wedges or hexahedra. Neighbours share the nodes between them,
 * so their surfaces fit, and the inner ones vanish as between linear cells. An
 * octahedron between the nodes of a tetrahedron becomes four tetrahedra round
 * one of its diagonals. Pyramids, Bezier cells, whose inner nodes are not on the
 * surface, and the types 60 to 67, whose nodes have no defined order, become the
 * linear cell of their corners.
 *
 * The result depends on the file alone. VTK draws such cells in ways that differ
 * with its version, and crashes on some.
 */

#ifndef LinearCells_h
#define LinearCells_h

#include "vtkSmartPointer.h"

class vtkUnstructuredGrid;

namespace lambent::command
{

/// The grid itself if it has no cell of the types 60 to 81, or if it has arrays that are too short;
/// otherwise one with linear cells in their place, on the same points. The cells have passed
/// CheckCells().
vtkSmartPointer<vtkUnstructuredGrid> WithLinearCells(vtkUnstructuredGrid* grid);

} // namespace lambent::command

#endif
