// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckPolygons.h"

#include "vtkCellArray.h"
#include "vtkObject.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>
#include <vector>

namespace lambent::command
{
namespace
{

/// Appends "1 line" or "3 lines" to the list; appends nothing if the count is 0.
void List(
  std::vector<std::string>& list, vtkIdType count, const std::string& noun, const char* what = "")
{
  if (count > 0)
  {
    list.push_back(std::to_string(count) + " " + noun + (count == 1 ? "" : "s") + what);
  }
}

} // namespace

vtkIdType CountTriangles(vtkPolyData* mesh)
{
  vtkIdType count = 0;
  for (vtkCellArray* const cells : { mesh->GetPolys(), mesh->GetStrips() })
  {
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      count += std::max<vtkIdType>(cells->GetCellSize(cell) - 2, 0);
    }
  }
  return count;
}

void CheckPolygons(vtkPolyData* mesh, vtkDataObject* data)
{
  if (CountTriangles(mesh) > 0 || mesh->GetNumberOfLines() + mesh->GetNumberOfVerts() > 0)
  {
    return;
  }
  std::vector<std::string> list;
  List(list, data->GetNumberOfElements(vtkDataObject::POINT), "point");
  List(
    list, mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips(), "cell", " of fewer than 3 points");
  std::string what = list.empty() ? "no points" : list.front();
  for (std::size_t i = 1; i < list.size(); ++i)
  {
    what += (i + 1 < list.size() ? ", " : " and ") + list[i];
  }
  vtkGenericWarningMacro(<< "it holds " << what
                         << ", and no polygons, lines or vertices, which are what is drawn");
}

} // namespace lambent::command
