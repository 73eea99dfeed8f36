// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkStellate.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>

vtkStandardNewMacro(vtkStellate);

namespace
{
/// The position of the apex over a polygon, along Newell's normal. Uses only + - * / and sqrt, so
/// that the picture is the same on every machine.
void findApex(
  vtkPoints* points, vtkIdType size, const vtkIdType* ids, double height, double apex[3])
{
  double normal[3] = { 0, 0, 0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    apex[axis] = 0;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (vtkIdType k = 0; k < size; ++k)
    {
      double a[3], b[3];
      points->GetPoint(ids[k], a);
      points->GetPoint(ids[(k + 1) % size], b);
      apex[axis] += a[axis] / static_cast<double>(size);
      normal[axis] += (a[u] - b[u]) * (a[v] + b[v]);
    }
  }
  const double length =
    std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
#ifdef STELLATE_WITH_A_BUG
  height = std::fabs(height); // "negative heights make no sense", somebody thought
#endif
  for (int axis = 0; axis < 3 && length > 0; ++axis)
  {
    apex[axis] += height * (normal[axis] / length);
  }
}
}

int vtkStellate::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  if (!input->GetPoints())
  {
    return 1;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(input->GetPoints());
  vtkNew<vtkCellArray> triangles;

  const auto polygon = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (polygon->GoToFirstCell(); !polygon->IsDoneWithTraversal(); polygon->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    polygon->GetCurrentCell(size, ids);
    double place[3];
    findApex(input->GetPoints(), size, ids, this->Height, place);
    const vtkIdType apex = points->InsertNextPoint(place);
    for (vtkIdType k = 0; k < size; ++k)
    {
      triangles->InsertNextCell({ ids[k], ids[(k + 1) % size], apex });
    }
  }
  output->SetPoints(points);
  output->SetPolys(triangles);
  return 1;
}

void vtkStellate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Height: " << this->Height << "\n";
}
