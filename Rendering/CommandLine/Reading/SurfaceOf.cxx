// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "SurfaceOf.h"
#include "CheckCells.h"
#include "LinearCells.h"
#include "Messages.h"
#include "Progress.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <vector>

namespace lambent::command
{
namespace
{

using Surfaces = std::vector<vtkSmartPointer<vtkPolyData>>;

void CheckDataSet(vtkDataSet* data)
{
  if (auto* const mesh = vtkPolyData::SafeDownCast(data))
  {
    CheckCells(mesh->GetPolys(), mesh->GetNumberOfPoints(), "polygon");
    CheckCells(mesh->GetStrips(), mesh->GetNumberOfPoints(), "strip");
  }
  else if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    CheckCells(grid);
  }
}

/// The data sets with points in a data object, after checking each.
std::vector<vtkDataSet*> DataSetsIn(vtkDataObject* data)
{
  std::vector<vtkDataSet*> found;
  const auto add = [&found](vtkDataObject* object)
  {
    auto* const dataSet = vtkDataSet::SafeDownCast(object);
    if (dataSet && dataSet->GetNumberOfPoints() > 0)
    {
      CheckDataSet(dataSet);
      found.push_back(dataSet);
    }
  };
  if (auto* const blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      add(iterator->GetCurrentDataObject());
    }
  }
  else
  {
    add(data);
  }
  return found;
}

vtkSmartPointer<vtkPolyData> OuterSurface(
  vtkDataSet* data, VtkMessages& messages, Progress& progress)
{
  if (auto* const mesh = vtkPolyData::SafeDownCast(data))
  {
    return mesh;
  }
  if (vtkImageData::SafeDownCast(data))
  {
    throw Failure("it is an image, which has no surface of its own; name one with "
                  "--contour VALUE[,ARRAY]; its arrays: " +
      DescribeArrays({ data }));
  }
  vtkSmartPointer<vtkDataSet> linear = data;
  if (auto* const grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    linear = WithLinearCells(grid);
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  progress.Follow(surface);
  surface->SetInputData(linear);
  surface->Update();
  const std::string error = messages.TakeError();
  if (!error.empty())
  {
    throw Failure(error);
  }
  return surface->GetOutput();
}

vtkSmartPointer<vtkPolyData> Append(const Surfaces& surfaces, VtkMessages& messages)
{
  if (surfaces.size() == 1)
  {
    return surfaces.front();
  }
  vtkNew<vtkAppendPolyData> append;
  for (vtkPolyData* const surface : surfaces)
  {
    append->AddInputData(surface);
  }
  append->Update();
  const std::string error = messages.TakeError();
  if (!error.empty())
  {
    throw Failure(error);
  }
  return append->GetOutput();
}

} // namespace

vtkSmartPointer<vtkPolyData> SurfaceOf(vtkDataObject* data,
  const std::optional<ContourValue>& contour, VtkMessages& messages, Progress& progress)
{
  const std::vector<vtkDataSet*> dataSets = DataSetsIn(data);
  if (dataSets.empty())
  {
    throw Failure("it has no mesh");
  }
  Surfaces surfaces;
  std::vector<vtkDataSet*> volumes;
  for (vtkDataSet* const dataSet : dataSets)
  {
    auto* const mesh = vtkPolyData::SafeDownCast(dataSet);
    if (mesh && dataSet != data)
    {
      mesh->RemoveGhostCells(); // a piece may repeat cells of its neighbours
    }
    if (contour && IsVolume(dataSet))
    {
      volumes.push_back(dataSet);
    }
    else
    {
      surfaces.push_back(OuterSurface(dataSet, messages, progress));
    }
  }
  if (!volumes.empty())
  {
    const Surfaces contours = ContoursOf(volumes, *contour, messages, progress);
    surfaces.insert(surfaces.end(), contours.begin(), contours.end());
  }
  else if (contour)
  {
    vtkGenericWarningMacro("it has no volume for --contour, so it is drawn unchanged");
  }
  return Append(surfaces, messages);
}

} // namespace lambent::command
