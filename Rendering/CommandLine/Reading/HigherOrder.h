// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the number of nodes of higher-order cells
 *
 * The number of nodes of VTK's cell types 60 to 81 depends on their order. The order follows from
 * the number of nodes, or is given in the cell array "HigherOrderDegrees", with a number for each
 * direction. vtkDataSetSurfaceFilter of VTK 9.1 crashes on Lagrange and Bezier tetrahedra and skips
 * pyramids and the types 60 to 67; VTK's classes for the other types rely on the number of nodes.
 */

#ifndef HigherOrder_h
#define HigherOrder_h

#include "vtkType.h"

#include <array>
#include <string>

class vtkUnstructuredGrid;

namespace lambent::command
{

/// The shape of a type of cell.
enum class Shape
{
  Linear, ///< not one of the types 60 to 81
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

/// Whether the nodes lie on the surface, as for Lagrange cells. In Bezier cells only the corners
/// do, and in the types 60 to 67 only the corners are defined.
bool IsLagrange(int type);

/// Whether VTK's readers sort the nodes of this type in older files: hexahedra.
bool IsSortedHexahedron(int type);

/// The order in each direction.
using Orders = std::array<int, 3>;

/// The orders of a cell of the types 60 to 81 that has passed CheckHigherOrder().
Orders OrdersOf(vtkUnstructuredGrid* grid, vtkIdType cell, int type);

/// Throws Failure if a cell of the types 60 to 81 has an invalid number of nodes.
void CheckHigherOrder(vtkUnstructuredGrid* grid, vtkIdType cell, int type);

/// The cell as named in messages: "its cell 3 of type 70 (vtkLagrangeQuadrilateral)".
std::string CellWithType(vtkIdType cell, int type);

/// The remedy for an invalid cell.
extern const char* const CorrectCell;

} // namespace lambent::command

#endif
