// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "HigherOrder.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <optional>

namespace lambent::command
{

const char* const CorrectCell =
  "; correct the type or the points of that cell in the program that writes the file";

Shape HigherOrderShape(int type)
{
  switch (type)
  {
    case VTK_HIGHER_ORDER_EDGE:
    case VTK_LAGRANGE_CURVE:
    case VTK_BEZIER_CURVE:
      return Shape::Edge;
    case VTK_HIGHER_ORDER_TRIANGLE:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_BEZIER_TRIANGLE:
      return Shape::Triangle;
    case VTK_HIGHER_ORDER_QUAD:
    case VTK_LAGRANGE_QUADRILATERAL:
    case VTK_BEZIER_QUADRILATERAL:
      return Shape::Quadrilateral;
    case VTK_HIGHER_ORDER_POLYGON:
      return Shape::Polygon;
    case VTK_HIGHER_ORDER_TETRAHEDRON:
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_BEZIER_TETRAHEDRON:
      return Shape::Tetrahedron;
    case VTK_HIGHER_ORDER_WEDGE:
    case VTK_LAGRANGE_WEDGE:
    case VTK_BEZIER_WEDGE:
      return Shape::Wedge;
    case VTK_HIGHER_ORDER_PYRAMID:
    case VTK_LAGRANGE_PYRAMID:
    case VTK_BEZIER_PYRAMID:
      return Shape::Pyramid;
    case VTK_HIGHER_ORDER_HEXAHEDRON:
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_BEZIER_HEXAHEDRON:
      return Shape::Hexahedron;
    default:
      return Shape::Linear;
  }
}

bool IsLagrange(int type)
{
  return type >= VTK_LAGRANGE_CURVE && type <= VTK_LAGRANGE_PYRAMID;
}

bool IsSortedHexahedron(int type)
{
  return HigherOrderShape(type) == Shape::Hexahedron;
}

namespace
{

/// An upper bound on the order, beyond any real cell.
constexpr int HighestOrder = 1000;

/// The number of nodes of a cell of these orders.
vtkIdType Nodes(Shape shape, const Orders& orders)
{
  const vtkIdType m = orders[0] + 1, n = orders[1] + 1, o = orders[2] + 1;
  switch (shape)
  {
    case Shape::Edge:
      return m;
    case Shape::Triangle:
      return m * (m + 1) / 2;
    case Shape::Quadrilateral:
      return m * n;
    case Shape::Polygon:
      return 2 * m;
    case Shape::Tetrahedron:
      return m * (m + 1) * (m + 2) / 6;
    case Shape::Wedge:
      return m * (m + 1) / 2 * o;
    case Shape::Pyramid:
      return m * (m + 1) * (2 * m + 1) / 6;
    case Shape::Hexahedron:
      return m * n * o;
    case Shape::Linear:
      break;
  }
  return 0;
}

/// The least order of a shape: a polygon of order m has m + 1 corners.
int LeastOrder(Shape shape)
{
  return shape == Shape::Polygon ? 2 : 1;
}

/// Whether a cell is of order 2 with additional nodes at the centres, after the others.
bool IsSecondOrderWithCentres(Shape shape, vtkIdType count)
{
  return (shape == Shape::Triangle && count == 7) || (shape == Shape::Tetrahedron && count == 15) ||
    (shape == Shape::Wedge && count == 21);
}

/// The number of independent orders.
int Directions(Shape shape)
{
  switch (shape)
  {
    case Shape::Wedge:
    case Shape::Hexahedron:
      return 3;
    case Shape::Quadrilateral:
      return 2;
    default:
      return 1; // the same order in all directions
  }
}

/// The array with the orders, found by name as VTK's readers do.
vtkDataArray* DegreesOf(vtkUnstructuredGrid* grid)
{
  return grid->GetCellData()->GetArray("HigherOrderDegrees");
}

/// The orders in that array, if they match the number of nodes.
std::optional<Orders> GivenOrders(
  vtkUnstructuredGrid* grid, vtkIdType cell, Shape shape, vtkIdType count)
{
  vtkDataArray* const degrees = DegreesOf(grid);
  if (!degrees || degrees->GetNumberOfComponents() != 3 || cell >= degrees->GetNumberOfTuples())
  {
    return std::nullopt;
  }
  Orders orders{ 1, 1, 1 };
  for (int axis = 0; axis < Directions(shape); ++axis)
  {
    const double degree = degrees->GetComponent(cell, axis);
    if (!(degree >= 1.0 && degree <= HighestOrder))
    {
      return std::nullopt;
    }
    orders[axis] = static_cast<int>(degree);
  }
  return Nodes(shape, orders) == count ? std::make_optional(orders) : std::nullopt;
}

std::optional<Orders> EqualOrders(Shape shape, vtkIdType count)
{
  if (IsSecondOrderWithCentres(shape, count))
  {
    return Orders{ 2, 2, 2 };
  }
  for (int order = LeastOrder(shape); order <= HighestOrder; ++order)
  {
    const vtkIdType nodes = Nodes(shape, { order, order, order });
    if (nodes >= count)
    {
      return nodes == count ? std::make_optional<Orders>({ order, order, order }) : std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<Orders> FindOrders(vtkUnstructuredGrid* grid, vtkIdType cell, Shape shape)
{
  const vtkIdType count = grid->GetCells()->GetCellSize(cell);
  const std::optional<Orders> given = GivenOrders(grid, cell, shape, count);
  if (given || (shape == Shape::Hexahedron && DegreesOf(grid)))
  {
    return given; // VTK sorts the nodes of hexahedra by the array, whether it fits or not
  }
  return EqualOrders(shape, count);
}

} // namespace

Orders OrdersOf(vtkUnstructuredGrid* grid, vtkIdType cell, int type)
{
  return FindOrders(grid, cell, HigherOrderShape(type)).value_or(Orders{ 1, 1, 1 });
}

void CheckHigherOrder(vtkUnstructuredGrid* grid, vtkIdType cell, int type)
{
  const Shape shape = HigherOrderShape(type);
  if (FindOrders(grid, cell, shape))
  {
    return;
  }
  if (shape == Shape::Hexahedron && DegreesOf(grid))
  {
    throw Failure(CellWithType(cell, type) +
      " does not have the number of points that its orders in the array "
      "HigherOrderDegrees require" +
      CorrectCell);
  }
  std::string counts;
  for (int order = LeastOrder(shape); order < LeastOrder(shape) + 3; ++order)
  {
    counts += std::to_string(Nodes(shape, { order, order, order })) + ", ";
  }
  throw Failure(CellWithType(cell, type) + " has " +
    std::to_string(grid->GetCells()->GetCellSize(cell)) + " points; such cells have " + counts +
    "... points" + CorrectCell);
}

std::string CellWithType(vtkIdType cell, int type)
{
  const auto known = vtkSmartPointer<vtkCell>::Take(vtkGenericCell::InstantiateCell(type));
  return "its cell " + std::to_string(cell) + " of type " + std::to_string(type) +
    (known ? std::string(" (") + known->GetClassName() + ")" : "");
}

} // namespace lambent::command
