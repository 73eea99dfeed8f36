// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CheckPolygons.h"

#include "vtkCellArray.h"
#include "vtkObject.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>

namespace lambent::command
{
namespace
{

/// ", 1 line" or ", 3 lines"; nothing for none.
std::string Counted(vtkIdType count, const std::string& noun)
{
  return count == 0 ? "" : ", " + std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
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

void CheckPolygons(vtkPolyData* mesh)
{
  if (CountTriangles(mesh) > 0)
  {
    return;
  }
  const vtkIdType degenerate = mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips();
  const std::string what = Counted(mesh->GetNumberOfPoints(), "point").substr(2) +
    Counted(mesh->GetNumberOfLines(), "line") + Counted(degenerate, "cell") +
    (degenerate > 0 ? " of fewer than 3 points" : "");
  vtkGenericWarningMacro(<< "it holds " << what
                         << ", and no polygons; Lambent draws only polygons so far");
}

} // namespace lambent::command
