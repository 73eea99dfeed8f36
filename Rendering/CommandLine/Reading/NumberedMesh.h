// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief nodes and elements with numbers of their own, as files of simulations have them
 *
 * Elements name nodes by any numbers, in any order, before or after the nodes
 * themselves. The nodes of a part are sorted by number once, when it is whole.
 */

#ifndef NumberedMesh_h
#define NumberedMesh_h

#include "vtkCellType.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkPointSet;

namespace lambent::command
{

/// What is drawn of an element: the linear cell of its corners, which come first of its nodes. A
/// triangle, quadrilateral, tetrahedron, pyramid or hexahedron has them in the order of VTK, a
/// wedge has its first triangle the other way round: it is seen from inside.
struct ElementShape
{
  int cellType = VTK_EMPTY_CELL;
  int corners = 0;
};

class NumberedMesh
{
public:
  /// If `isLast`, the last node of several with one number counts; otherwise that is an error.
  explicit NumberedMesh(bool isLast)
    : IsLast(isLast)
  {
  }

  void AddNode(std::int64_t number, const double coordinates[3]);
  /// Needs at least as many nodes as the shape has corners.
  void AddElement(std::int64_t number, ElementShape shape, const std::vector<std::int64_t>& nodes);

  /// From now on nodes are numbered anew.
  void EndPart();

  /// All parts as one grid, or if nothing in them has a volume, as polygons. Nodes that no element
  /// names are left out, unless there are no elements.
  vtkSmartPointer<vtkPointSet> MakeData();

private:
  struct Node
  {
    std::int64_t number;
    std::int64_t id;
  };

  void SortNodes();
  void DropUnusedNodes();
  /// The id of the node with that number, -1 if there is none.
  std::int64_t FindNode(std::int64_t number) const;

  bool IsLast;
  std::vector<Node> Nodes;                // of this part
  std::vector<double> Coordinates;        // of all parts
  std::vector<std::int64_t> Elements;     // the numbers of those of this part
  std::vector<unsigned char> Types;       // of all parts
  std::vector<std::int64_t> Offsets{ 0 }; // of all parts
  std::vector<std::int64_t> Connectivity; // ids, and behind them the numbers of this part
};

} // namespace lambent::command

#endif
