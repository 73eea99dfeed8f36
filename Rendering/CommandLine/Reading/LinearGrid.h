// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief builds a grid from another one, cell by cell
 */

#ifndef LinearGrid_h
#define LinearGrid_h

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <initializer_list>

namespace lambent::command
{

/// The new grid has the points of the other one. Each added cell has the data of its source cell.
class LinearGrid
{
public:
  explicit LinearGrid(vtkUnstructuredGrid* grid)
    : From(grid)
    , Result(vtkSmartPointer<vtkUnstructuredGrid>::New())
  {
    this->Result->SetPoints(grid->GetPoints());
    this->Result->GetPointData()->ShallowCopy(grid->GetPointData());
    this->Result->GetFieldData()->ShallowCopy(grid->GetFieldData());
    this->Result->Allocate(grid->GetNumberOfCells());
    this->Result->GetCellData()->CopyAllOn();
    this->Result->GetCellData()->CopyAllocate(grid->GetCellData(), grid->GetNumberOfCells());
  }

  /// Starts a source cell, whose nodes the following cells use.
  void Begin(vtkIdType cell)
  {
    this->Cell = cell;
    this->From->GetCellPoints(cell, this->Nodes);
  }

  vtkIdType NodeCount() const { return this->Nodes->GetNumberOfIds(); }

  void Add(int type, std::initializer_list<vtkIdType> nodes)
  {
    this->Add(type, nodes.begin(), static_cast<vtkIdType>(nodes.size()));
  }

  void Add(int type, const vtkIdType* nodes, vtkIdType count)
  {
    this->Ids->SetNumberOfIds(count);
    for (vtkIdType k = 0; k < count; ++k)
    {
      this->Ids->SetId(k, this->Nodes->GetId(nodes[k]));
    }
    this->CopyData(this->Result->InsertNextCell(type, this->Ids));
  }

  /// Adds a cell of the first `count` nodes.
  void AddCorners(int type, vtkIdType count)
  {
    vtkNew<vtkIdList> nodes;
    nodes->SetNumberOfIds(count);
    for (vtkIdType k = 0; k < count; ++k)
    {
      nodes->SetId(k, k);
    }
    this->Add(type, nodes->GetPointer(0), count);
  }

  /// Adds the source cell unchanged.
  void AddSame(int type)
  {
    if (type == VTK_POLYHEDRON)
    {
      this->From->GetFaceStream(this->Cell, this->Ids);
      this->CopyData(this->Result->InsertNextCell(type, this->Ids));
      return;
    }
    this->CopyData(this->Result->InsertNextCell(type, this->Nodes));
  }

  vtkSmartPointer<vtkUnstructuredGrid> Get() const { return this->Result; }

private:
  void CopyData(vtkIdType to)
  {
    this->Result->GetCellData()->CopyData(this->From->GetCellData(), this->Cell, to);
  }

  vtkUnstructuredGrid* From;
  vtkSmartPointer<vtkUnstructuredGrid> Result;
  vtkNew<vtkIdList> Nodes;
  vtkNew<vtkIdList> Ids;
  vtkIdType Cell = 0;
};

} // namespace lambent::command

#endif
