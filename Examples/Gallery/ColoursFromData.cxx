// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The number s = 3 x (x^2 - 3 y^2) on three balls, through one table of nine colours. Left: the
// colours of the points are interpolated. Middle: the numbers are interpolated and then looked up,
// which gives the table's colours only. Right: one colour for each face, that of its mean.

#include "Gallery.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"

namespace
{

/// From blue over white to red.
vtkSmartPointer<vtkLookupTable> BlueToRed()
{
  const int steps = 4;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(2 * steps + 1);
  table->SetRange(-1, 1);
  table->Build();
  for (int k = -steps; k <= steps; ++k)
  {
    const double t = static_cast<double>(k) / steps, pale = 1 - t * t;
    const double red = t > 0 ? 1 - 0.25 * t * t : pale, blue = t < 0 ? 1 - 0.25 * t * t : pale;
    table->SetTableValue(k + steps, red, pale, blue);
  }
  return table;
}

/// Adds the number of each point, and of each cell the mean of its points, as active scalars.
void AddNumbers(vtkPolyData* ball, double center, bool isOfCells)
{
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("s");
  numbers->SetNumberOfTuples(ball->GetNumberOfPoints());
  for (vtkIdType k = 0; k < ball->GetNumberOfPoints(); ++k)
  {
    const double x = ball->GetPoint(k)[0] - center, y = ball->GetPoint(k)[1];
    numbers->SetValue(k, 3 * x * (x * x - 3 * y * y));
  }
  if (!isOfCells)
  {
    ball->GetPointData()->SetScalars(numbers);
    return;
  }
  vtkNew<vtkDoubleArray> means;
  means->SetName("s");
  for (vtkIdType cell = 0; cell < ball->GetNumberOfCells(); ++cell)
  {
    vtkIdList* const points = ball->GetCell(cell)->GetPointIds();
    double sum = 0;
    for (vtkIdType k = 0; k < points->GetNumberOfIds(); ++k)
    {
      sum += numbers->GetValue(points->GetId(k));
    }
    means->InsertNextValue(sum / static_cast<double>(points->GetNumberOfIds()));
  }
  ball->GetCellData()->SetScalars(means);
}

} // namespace

int main(int argc, char* argv[])
{
  const auto property = gallery::Surface(1, 1, 1);
  property->SetDiffuse(0.85);
  property->SetAmbient(0.15);
  const auto table = BlueToRed();

  vtkNew<vtkLambentRayTracer> tracer;
  for (int k = 0; k < 3; ++k)
  {
    const auto ball = gallery::Sphere(k * gallery::Step);
    AddNumbers(ball, k * gallery::Step, k == 2);
    gallery::AddSurface(tracer, ball, property);
    tracer->SetInputScalarVisibility(k, true);
    tracer->SetInputLookupTable(k, table);
  }
  tracer->SetInputInterpolateScalarsBeforeMapping(1, true);
  gallery::AddLight(tracer, -2, 3, 4);
  gallery::ShowPlaces(tracer, 3, 1, 240);
  return gallery::Save(tracer, "ColoursFromData.png", argc, argv);
}
