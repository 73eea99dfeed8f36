// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief how many nodes a cell of any order has
 *
 * The types 60 to 81 of VTK have as many nodes as their order asks for: it
 * follows from the count of nodes, or is in the cell array "HigherOrderDegrees",
 * one number for each direction. vtkDataSetSurfaceFilter of VTK 9.1 crashes on
 * Lagrange and Bezier tetrahedra, leaves out pyramids and the types 60 to 67,
 * and its classes for the others rely on the count.
 */

#ifndef HigherOrder_h
#define HigherOrder_h

#include "vtkType.h"

#include <array>
#include <string>

class vtkUnstructuredGrid;

namespace lambent::command
{

/// What the cells of a type look like.
enum class Shape
{
  Linear, ///< not of a type 60 to 81
  Edge,
  Triangle,
  Quadrilateral,
  Polygon,
  Tetrahedron,
  Wedge,
  Pyramid,
  Hexahedron
};
Shape HigherOrderShape(int type);

/// Lagrange cells have their nodes on the surface; those of Bezier cells, but for the corners, are
/// not, and of the types 60 to 67 only the corners are known.
bool IsLagrange(int type);

/// VTK's readers sort the nodes of hexahedra from older files.
bool IsSortedHexahedron(int type);

/// The order in each direction.
using Orders = std::array<int, 3>;

/// Of a cell of one of those types, after CheckHigherOrder().
Orders OrdersOf(vtkUnstructuredGrid* grid, vtkIdType cell, int type);

/// Throws Failure if a cell of one of those types has a count of nodes that it cannot have.
void CheckHigherOrder(vtkUnstructuredGrid* grid, vtkIdType cell, int type);

/// "its cell 3 of type 70 (vtkLagrangeQuadrilateral)"
std::string CellWithType(vtkIdType cell, int type);

/// What to do about a cell that was written wrong.
extern const char* const CorrectCell;

} // namespace lambent::command

#endif
