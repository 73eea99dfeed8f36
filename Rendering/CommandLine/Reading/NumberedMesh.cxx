// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "NumberedMesh.h"
#include "CellLists.h"
#include "Messages.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace lambent::command
{

void NumberedMesh::AddNode(std::int64_t number, const double coordinates[3])
{
  this->Nodes.push_back({ number, static_cast<std::int64_t>(this->Coordinates.size() / 3) });
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!std::isfinite(coordinates[axis]))
    {
      throw Failure("node " + std::to_string(number) +
        " has a coordinate that is not a finite number; correct it in the program that writes the "
        "file");
    }
    this->Coordinates.push_back(coordinates[axis]);
  }
}

void NumberedMesh::AddElement(
  std::int64_t number, ElementShape shape, const std::vector<std::int64_t>& nodes)
{
  this->Elements.push_back(number);
  this->Types.push_back(static_cast<unsigned char>(shape.cellType));
  this->Connectivity.insert(this->Connectivity.end(), nodes.begin(), nodes.begin() + shape.corners);
  if (shape.cellType == VTK_WEDGE)
  {
    const auto wedge = this->Connectivity.end() - 6;
    std::swap(wedge[1], wedge[2]);
    std::swap(wedge[4], wedge[5]);
  }
  this->Offsets.push_back(static_cast<std::int64_t>(this->Connectivity.size()));
}

void NumberedMesh::SortNodes()
{
  const auto isBefore = [](const Node& a, const Node& b) { return a.number < b.number; };
  if (!std::is_sorted(this->Nodes.begin(), this->Nodes.end(), isBefore))
  {
    std::stable_sort(this->Nodes.begin(), this->Nodes.end(), isBefore);
  }
  if (!this->IsLast)
  {
    const auto twice = std::adjacent_find(this->Nodes.begin(), this->Nodes.end(),
      [](const Node& a, const Node& b) { return a.number == b.number; });
    if (twice != this->Nodes.end())
    {
      throw Failure("it has two nodes with the number " + std::to_string(twice->number) +
        "; correct it in the program that writes the file");
    }
  }
}

std::int64_t NumberedMesh::FindNode(std::int64_t number) const
{
  const auto behind = std::upper_bound(this->Nodes.begin(), this->Nodes.end(), number,
    [](std::int64_t wanted, const Node& node) { return wanted < node.number; });
  return behind != this->Nodes.begin() && behind[-1].number == number ? behind[-1].id : -1;
}

void NumberedMesh::EndPart()
{
  this->SortNodes();
  const std::size_t first = this->Types.size() - this->Elements.size();
  for (std::size_t element = 0; element < this->Elements.size(); ++element)
  {
    for (std::int64_t at = this->Offsets[first + element]; at < this->Offsets[first + element + 1];
         ++at)
    {
      std::int64_t& node = this->Connectivity[static_cast<std::size_t>(at)];
      const std::int64_t id = this->FindNode(node);
      if (id < 0)
      {
        throw Failure("its element " + std::to_string(this->Elements[element]) + " uses node " +
          std::to_string(node) +
          ", which does not exist; correct it in the program that writes the file, or use a "
          "complete copy");
      }
      node = id;
    }
  }
  this->Nodes.clear();
  this->Elements.clear();
}

/// Unused nodes would enlarge the bounds of the mesh.
void NumberedMesh::DropUnusedNodes()
{
  std::vector<std::int64_t> ids(this->Coordinates.size() / 3, -1);
  for (const std::int64_t id : this->Connectivity)
  {
    ids[static_cast<std::size_t>(id)] = 0;
  }
  std::int64_t used = 0;
  for (std::size_t id = 0; id < ids.size(); ++id)
  {
    if (ids[id] == 0)
    {
      std::copy_n(&this->Coordinates[3 * id], 3, &this->Coordinates[3 * used]);
      ids[id] = used++;
    }
  }
  this->Coordinates.resize(3 * static_cast<std::size_t>(used));
  for (std::int64_t& id : this->Connectivity)
  {
    id = ids[static_cast<std::size_t>(id)];
  }
}

vtkSmartPointer<vtkPointSet> NumberedMesh::MakeData()
{
  this->EndPart();
  if (!this->Types.empty())
  {
    this->DropUnusedNodes();
  }
  vtkNew<vtkPoints> points;
  points->SetData(MakeArray<vtkDoubleArray>(this->Coordinates, 3));
  vtkNew<vtkCellArray> cells;
  cells->SetData(MakeArray<vtkTypeInt64Array>(this->Offsets, 1),
    MakeArray<vtkTypeInt64Array>(this->Connectivity, 1));
  if (std::all_of(this->Types.begin(), this->Types.end(),
        [](unsigned char type) { return type == VTK_TRIANGLE || type == VTK_QUAD; }))
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    return mesh;
  }
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->SetCells(MakeArray<vtkUnsignedCharArray>(this->Types, 1), cells);
  return grid;
}

} // namespace lambent::command
