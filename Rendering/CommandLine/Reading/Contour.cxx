// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Contour.h"
#include "Messages.h"
#include "Progress.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkContourFilter.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <sstream>

namespace lambent::command
{
namespace
{

using Range = std::array<double, 2>;

bool IsContourable(vtkDataArray* array)
{
  return array && array->GetName() && array->GetNumberOfComponents() == 1 &&
    array->GetNumberOfTuples() > 0 && std::string(array->GetName()) != "vtkGhostType" &&
    std::string(array->GetName()) != "vtkValidPointMask";
}

/// Calls visit(array, isOfPoints) for each named array with one component.
template <typename Visit>
void ForEachArray(vtkDataSet* data, Visit visit)
{
  for (vtkDataSetAttributes* attributes :
    { static_cast<vtkDataSetAttributes*>(data->GetPointData()),
      static_cast<vtkDataSetAttributes*>(data->GetCellData()) })
  {
    for (int k = 0; k < attributes->GetNumberOfArrays(); ++k)
    {
      vtkDataArray* const array = attributes->GetArray(k);
      if (IsContourable(array))
      {
        visit(array, attributes == data->GetPointData());
      }
    }
  }
}

/// The array to contour if the user named none.
std::string DefaultArray(const std::vector<vtkDataSet*>& volumes)
{
  std::set<std::string> ofPoints, ofCells;
  for (vtkDataSet* const volume : volumes)
  {
    vtkDataArray* const scalars = volume->GetPointData()->GetScalars();
    if (IsContourable(scalars))
    {
      return scalars->GetName();
    }
    ForEachArray(volume,
      [&](vtkDataArray* array, bool isOfPoints)
      { (isOfPoints ? ofPoints : ofCells).insert(array->GetName()); });
  }
  const std::set<std::string>& names = ofPoints.empty() ? ofCells : ofPoints;
  if (names.size() != 1)
  {
    throw Failure((names.empty() ? "it has no array with one value per point or cell"
                                 : "--contour does not name one of its arrays") +
      std::string("; its arrays: ") + DescribeArrays(volumes));
  }
  return *names.begin();
}

/// Returns the volume with the array as point data, or null if there is no such array. If it is a
/// cell array, all cell arrays become point data.
vtkSmartPointer<vtkDataSet> WithPointArray(vtkDataSet* volume, const std::string& name)
{
  if (IsContourable(volume->GetPointData()->GetArray(name.c_str())))
  {
    return volume;
  }
  if (!IsContourable(volume->GetCellData()->GetArray(name.c_str())))
  {
    return nullptr;
  }
  vtkNew<vtkCellDataToPointData> average;
  average->SetInputData(volume);
  average->Update();
  return vtkDataSet::SafeDownCast(average->GetOutputDataObject(0));
}

/// Gives active scalars without a name the name "scalars", so that they can be contoured too.
void NameScalars(vtkDataSet* volume)
{
  for (vtkDataSetAttributes* attributes :
    { static_cast<vtkDataSetAttributes*>(volume->GetPointData()),
      static_cast<vtkDataSetAttributes*>(volume->GetCellData()) })
  {
    vtkDataArray* const scalars = attributes->GetScalars();
    if (scalars && (!scalars->GetName() || !*scalars->GetName()))
    {
      scalars->SetName("scalars");
    }
  }
}

bool IsSolidImage(vtkDataSet* volume)
{
  auto* const image = vtkImageData::SafeDownCast(volume);
  const int* const size = image ? image->GetDimensions() : nullptr;
  return image && size[0] > 1 && size[1] > 1 && size[2] > 1;
}

template <typename Filter>
vtkSmartPointer<vtkPolyData> Cut(Filter* filter, vtkDataSet* volume, const std::string& array,
  double value, VtkMessages& messages, Progress& progress)
{
  progress.Follow(filter);
  filter->SetInputData(volume);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  filter->SetValue(0, value);
  filter->Update();
  const std::string error = messages.TakeError();
  if (!error.empty())
  {
    throw Failure(error);
  }
  return filter->GetOutput();
}

} // namespace

bool IsVolume(vtkDataSet* data)
{
  return data && !vtkPolyData::SafeDownCast(data);
}

std::string DescribeArrays(const std::vector<vtkDataSet*>& volumes)
{
  std::map<std::string, Range> ranges;
  for (vtkDataSet* const volume : volumes)
  {
    NameScalars(volume);
    ForEachArray(volume,
      [&ranges](vtkDataArray* array, bool)
      {
        Range range;
        array->GetFiniteRange(range.data());
        const auto [known, isNew] = ranges.emplace(array->GetName(), range);
        known->second[0] = std::min(known->second[0], range[0]);
        known->second[1] = std::max(known->second[1], range[1]);
      });
  }
  std::ostringstream text;
  for (const auto& [name, range] : ranges)
  {
    text << (text.tellp() > 0 ? ", " : "") << name << " from " << range[0] << " to " << range[1];
  }
  return ranges.empty() ? "none" : text.str();
}

std::vector<vtkSmartPointer<vtkPolyData>> ContoursOf(const std::vector<vtkDataSet*>& volumes,
  const ContourValue& contour, VtkMessages& messages, Progress& progress)
{
  for (vtkDataSet* const volume : volumes)
  {
    NameScalars(volume);
  }
  const std::string name = contour.array.empty() ? DefaultArray(volumes) : contour.array;
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  bool isKnown = false;
  for (vtkDataSet* const volume : volumes)
  {
    const vtkSmartPointer<vtkDataSet> data = WithPointArray(volume, name);
    if (!data)
    {
      continue;
    }
    isKnown = true;
    vtkNew<vtkFlyingEdges3D> edges;
    edges->SetInterpolateAttributes(contour.keepsArrays);
    const auto surface = IsSolidImage(data)
      ? Cut(edges.Get(), data, name, contour.value, messages, progress)
      : Cut(vtkNew<vtkContourFilter>().Get(), data, name, contour.value, messages, progress);
    if (surface->GetNumberOfPolys() > 0)
    {
      surfaces.push_back(surface);
    }
  }
  if (surfaces.empty())
  {
    std::ostringstream value;
    value << contour.value;
    throw Failure((isKnown ? "no surface in it has " + name + " = " + value.str()
                           : "it has no array '" + name + "' with one value per point or cell") +
      "; its arrays: " + DescribeArrays(volumes));
  }
  return surfaces;
}

} // namespace lambent::command
