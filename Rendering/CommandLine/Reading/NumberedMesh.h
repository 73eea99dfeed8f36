// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a mesh of numbered nodes and elements, as in simulation files
 *
 * Elements refer to nodes by arbitrary numbers, in any order, before or after the nodes themselves.
 * The nodes of a part are sorted by number once, when the part is complete.
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

/// The cell drawn for an element: the linear cell of its corners, which are its first nodes. The
/// corners of a triangle, quadrilateral, tetrahedron, pyramid or hexahedron are in VTK's order. The
/// triangles of a wedge have the opposite orientation to VTK's.
struct ElementShape
{
  int cellType = VTK_EMPTY_CELL;
  int corners = 0;
};

class NumberedMesh
{
public:
  /// If `isLast`, the last of several nodes with the same number is used; otherwise several are an
  /// error.
  explicit NumberedMesh(bool isLast)
    : IsLast(isLast)
  {
  }

  void AddNode(std::int64_t number, const double coordinates[3]);
  /// There must be at least as many nodes as the shape has corners.
  void AddElement(std::int64_t number, ElementShape shape, const std::vector<std::int64_t>& nodes);

  /// Ends a part; the next one may use the same node numbers again.
  void EndPart();

  /// All parts as one grid, or as polygons if all elements are triangles and quadrilaterals. Nodes
  /// that no element names are dropped, unless there are no elements.
  vtkSmartPointer<vtkPointSet> MakeData();

private:
  struct Node
  {
    std::int64_t number;
    std::int64_t id;
  };

  void SortNodes();
  void DropUnusedNodes();
  /// The id of the node with that number; -1 if there is none.
  std::int64_t FindNode(std::int64_t number) const;

  bool IsLast;
  std::vector<Node> Nodes;                // of this part
  std::vector<double> Coordinates;        // of all parts
  std::vector<std::int64_t> Elements;     // the element numbers of this part
  std::vector<unsigned char> Types;       // of all parts
  std::vector<std::int64_t> Offsets{ 0 }; // of all parts
  std::vector<std::int64_t> Connectivity; // ids of ended parts, then node numbers of this part
};

} // namespace lambent::command

#endif
