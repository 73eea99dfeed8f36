// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzArrays.h"

#include "FuzzColors.h"
#include "FuzzMesh.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

namespace
{
/// The right number of tuples, or seldom another one.
int lengthOf(FuzzInput& input, vtkIdType count)
{
  return input.seldom(4) ? input.choice(24) : static_cast<int>(count);
}

void add(FuzzInput& input, const char* name, vtkIdType count, vtkDataSetAttributes* data)
{
  const auto array = makeFuzzTuples(input, static_cast<int>(count), 3);
  array->SetName(name);
  data->AddArray(array);
}

/// Colours or numbers, which may have their own table.
void setScalars(FuzzInput& input, vtkIdType count, vtkDataSetAttributes* data)
{
  const int length = lengthOf(input, count);
  if (input.flag())
  {
    data->SetScalars(makeFuzzTuples(input, length, 1));
    if (input.seldom(32))
    {
      data->GetScalars()->SetLookupTable(makeFuzzLookupTable(input));
    }
    return;
  }
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(input.seldom(4) ? 5 : 1 + input.choice(4));
  colors->SetNumberOfTuples(length);
  for (vtkIdType k = 0; k < colors->GetNumberOfValues(); ++k)
  {
    colors->SetValue(k, input.byte());
  }
  data->SetScalars(colors);
}

void addGhosts(FuzzInput& input, vtkIdType count, vtkDataSetAttributes* data)
{
  const char* const name = vtkDataSetAttributes::GhostArrayName();
  if (input.seldom(4))
  {
    add(input, name, count, data); // of any type
    return;
  }
  vtkNew<vtkUnsignedCharArray> flags;
  flags->SetName(name);
  flags->SetNumberOfTuples(lengthOf(input, count));
  for (vtkIdType k = 0; k < flags->GetNumberOfValues(); ++k)
  {
    flags->SetValue(k, input.seldom(64) ? input.byte() : static_cast<unsigned char>(0));
  }
  data->AddArray(flags);
}

void addRadii(FuzzInput& input, vtkIdType count, vtkDataSetAttributes* data)
{
  vtkNew<vtkFloatArray> radii;
  radii->SetName("Radius");
  radii->SetNumberOfTuples(lengthOf(input, count));
  for (vtkIdType k = 0; k < radii->GetNumberOfValues(); ++k)
  {
    radii->SetValue(
      k, static_cast<float>(input.seldom(2) ? input.number() : input.within(0.0, 2.0)));
  }
  data->AddArray(radii);
}
}

void addFuzzArrays(FuzzInput& input, vtkPolyData* mesh)
{
  vtkDataSetAttributes *const ofPoints = mesh->GetPointData(), *const ofCells = mesh->GetCellData();
  const vtkIdType points = mesh->GetNumberOfPoints(), cells = mesh->GetNumberOfCells();
  add(input, "Heat", points, ofPoints);
  add(input, "Part", cells, ofCells);
  const int bits = input.byte();
  if ((bits & 1) != 0)
  {
    setScalars(input, points, ofPoints);
  }
  if ((bits & 2) != 0)
  {
    setScalars(input, cells, ofCells);
  }
  if ((bits & 12) != 0)
  {
    ofPoints->SetTCoords(makeFuzzTuples(input, lengthOf(input, points), 2));
  }
  if ((bits & 16) != 0)
  {
    addGhosts(input, points, ofPoints);
  }
  if ((bits & 32) != 0)
  {
    addGhosts(input, cells, ofCells);
  }
  if ((bits & 192) != 0)
  {
    addRadii(input, points, ofPoints);
  }
}
