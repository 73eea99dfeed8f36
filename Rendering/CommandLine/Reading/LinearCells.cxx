// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "LinearCells.h"
#include "HigherOrder.h"
#include "LinearGrid.h"

#include "vtkCellType.h"
#include "vtkHigherOrderHexahedron.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkHigherOrderTetra.h"
#include "vtkHigherOrderTriangle.h"
#include "vtkHigherOrderWedge.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

namespace lambent::command
{
namespace
{

/// The nodes are the two ends, then the inner nodes along the curve.
void AddCurve(LinearGrid& grid)
{
  vtkNew<vtkIdList> nodes;
  nodes->InsertNextId(0);
  for (vtkIdType k = 2; k < grid.NodeCount(); ++k)
  {
    nodes->InsertNextId(k);
  }
  nodes->InsertNextId(1);
  grid.Add(VTK_POLY_LINE, nodes->GetPointer(0), nodes->GetNumberOfIds());
}

/// Calls add(a, b, c) for each triangle of a triangular lattice, where node(i, j) is i steps along
/// the first side and j steps along the last.
template <typename Node, typename Add>
void ForEachTriangle(int order, const Node& node, const Add& add)
{
  for (int j = 0; j < order; ++j)
  {
    for (int i = 0; i + j < order; ++i)
    {
      add(node(i, j), node(i + 1, j), node(i, j + 1));
      if (i + j + 1 < order)
      {
        add(node(i + 1, j), node(i + 1, j + 1), node(i, j + 1));
      }
    }
  }
}

void AddTriangles(LinearGrid& grid, int order)
{
  const auto node = [order](vtkIdType i, vtkIdType j)
  {
    const vtkIdType barycentric[] = { i, j, order - i - j };
    return vtkHigherOrderTriangle::Index(barycentric, order);
  };
  ForEachTriangle(order, node,
    [&grid](vtkIdType a, vtkIdType b, vtkIdType c) {
      grid.Add(VTK_TRIANGLE, { a, b, c });
    });
}

void AddQuads(LinearGrid& grid, const Orders& orders)
{
  const auto node = [&orders](int i, int j) -> vtkIdType
  { return vtkHigherOrderQuadrilateral::PointIndexFromIJK(i, j, orders.data()); };
  for (int j = 0; j < orders[1]; ++j)
  {
    for (int i = 0; i < orders[0]; ++i)
    {
      grid.Add(VTK_QUAD, { node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1) });
    }
  }
}

void AddHexahedra(LinearGrid& grid, const Orders& orders)
{
  const auto node = [&orders](int i, int j, int k) -> vtkIdType
  { return vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, orders.data()); };
  for (int k = 0; k < orders[2]; ++k)
  {
    for (int j = 0; j < orders[1]; ++j)
    {
      for (int i = 0; i < orders[0]; ++i)
      {
        grid.Add(VTK_HEXAHEDRON,
          { node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
            node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1),
            node(i, j + 1, k + 1) });
      }
    }
  }
}

void AddWedges(LinearGrid& grid, const Orders& orders)
{
  const int all[] = { orders[0], orders[1], orders[2], static_cast<int>(grid.NodeCount()) };
  for (int k = 0; k < orders[2]; ++k)
  {
    struct Pair
    {
      vtkIdType below, above;
    };
    const auto node = [&all, k](int i, int j) -> Pair
    {
      return { vtkHigherOrderWedge::PointIndexFromIJK(i, j, k, all),
        vtkHigherOrderWedge::PointIndexFromIJK(i, j, k + 1, all) };
    };
    ForEachTriangle(orders[0], node,
      [&grid](Pair a, Pair b, Pair c) {
        grid.Add(VTK_WEDGE, { a.below, b.below, c.below, a.above, b.above, c.above });
      });
  }
}

/// Adds the tetrahedra of the lattice cell at node(0, 0, 0), which is `left` steps from the far
/// face.
template <typename Node>
void AddTetrahedraAt(LinearGrid& grid, const Node& node, int left)
{
  const vtkIdType x = node(1, 0, 0), y = node(0, 1, 0), z = node(0, 0, 1);
  grid.Add(VTK_TETRA, { node(0, 0, 0), x, y, z });
  if (left < 2)
  {
    return;
  }
  const vtkIdType xy = node(1, 1, 0), xz = node(1, 0, 1), yz = node(0, 1, 1);
  grid.Add(VTK_TETRA, { yz, x, y, xy });
  grid.Add(VTK_TETRA, { yz, x, xy, xz });
  grid.Add(VTK_TETRA, { yz, x, xz, z });
  grid.Add(VTK_TETRA, { yz, x, z, y });
  if (left > 2)
  {
    grid.Add(VTK_TETRA, { xz, xy, yz, node(1, 1, 1) });
  }
}

void AddTetrahedra(LinearGrid& grid, int order)
{
  for (int k = 0; k < order; ++k)
  {
    for (int j = 0; j + k < order; ++j)
    {
      for (int i = 0; i + j + k < order; ++i)
      {
        const auto node = [=](int a, int b, int c)
        {
          const vtkIdType barycentric[] = { i + a, j + b, k + c, order - i - j - k - a - b - c };
          return vtkHigherOrderTetra::Index(barycentric, order);
        };
        AddTetrahedraAt(grid, node, order - i - j - k);
      }
    }
  }
}

/// Adds the linear cell of the corners.
void AddLinear(LinearGrid& grid, Shape shape)
{
  switch (shape)
  {
    case Shape::Edge:
      return grid.AddCorners(VTK_LINE, 2);
    case Shape::Triangle:
      return grid.AddCorners(VTK_TRIANGLE, 3);
    case Shape::Quadrilateral:
      return grid.AddCorners(VTK_QUAD, 4);
    case Shape::Polygon:
      return grid.AddCorners(VTK_POLYGON, grid.NodeCount() / 2);
    case Shape::Tetrahedron:
      return grid.AddCorners(VTK_TETRA, 4);
    case Shape::Wedge:
      return grid.AddCorners(VTK_WEDGE, 6);
    case Shape::Pyramid:
      return grid.AddCorners(VTK_PYRAMID, 5);
    case Shape::Hexahedron:
      return grid.AddCorners(VTK_HEXAHEDRON, 8);
    case Shape::Linear:
      return;
  }
}

void AddLagrange(LinearGrid& grid, Shape shape, const Orders& orders)
{
  // VTK has no numbering for the wedge of 21 nodes.
  if (shape == Shape::Edge)
  {
    AddCurve(grid);
  }
  else if (shape == Shape::Triangle)
  {
    AddTriangles(grid, orders[0]);
  }
  else if (shape == Shape::Quadrilateral)
  {
    AddQuads(grid, orders);
  }
  else if (shape == Shape::Tetrahedron)
  {
    AddTetrahedra(grid, orders[0]);
  }
  else if (shape == Shape::Wedge && grid.NodeCount() != 21)
  {
    AddWedges(grid, orders);
  }
  else if (shape == Shape::Hexahedron)
  {
    AddHexahedra(grid, orders);
  }
  else
  {
    AddLinear(grid, shape);
  }
}

} // namespace

vtkSmartPointer<vtkUnstructuredGrid> WithLinearCells(vtkUnstructuredGrid* grid)
{
  const vtkIdType count = grid->GetNumberOfCells();
  const auto shapeOf = [grid](vtkIdType cell) { return HigherOrderShape(grid->GetCellType(cell)); };
  vtkIdType first = 0; // the first higher-order cell
  while (first < count && shapeOf(first) == Shape::Linear)
  {
    ++first;
  }
  if (first == count || grid->CheckAttributes() != 0) // if an array is too short, VTK says which
  {
    return grid;
  }
  LinearGrid linear(grid);
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    const int type = grid->GetCellType(cell);
    const Shape shape = HigherOrderShape(type);
    linear.Begin(cell);
    if (shape == Shape::Linear)
    {
      linear.AddSame(type);
    }
    else if (IsLagrange(type))
    {
      AddLagrange(linear, shape, OrdersOf(grid, cell, type));
    }
    else
    {
      AddLinear(linear, shape);
    }
  }
  return linear.Get();
}

} // namespace lambent::command
