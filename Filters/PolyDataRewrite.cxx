// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PolyDataRewrite.h"

#include "Chunks.h"
#include "FacesFromVTK.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

namespace lambent::adapters
{
namespace
{
vtkSmartPointer<vtkIdList> consecutiveIds(vtkIdType first, vtkIdType count)
{
  auto ids = vtkSmartPointer<vtkIdList>::New();
  ids->SetNumberOfIds(count);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, first);
  return ids;
}

vtkSmartPointer<vtkTypeInt64Array> toArray(const IndexSpan& indices, const Parallel& parallel)
{
  auto array = vtkSmartPointer<vtkTypeInt64Array>::New();
  array->SetNumberOfValues(static_cast<vtkIdType>(indices.size));
  forEachPart(parallel, indices.size,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        array->SetValue(static_cast<vtkIdType>(i), static_cast<vtkTypeInt64>(indices[i]));
      }
    });
  return array;
}

// VTK's own copying relies on these lengths.
void checkLengths(vtkDataSetAttributes* data, vtkIdType expected, const std::string& kind)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != expected)
    {
      const std::string name = array->GetName() ? array->GetName() : "";
      throw std::runtime_error("The " + kind + " data array \"" + name + "\" has " +
        std::to_string(array->GetNumberOfTuples()) + " tuples, but there are " +
        std::to_string(expected) + " " + kind +
        "s, each of which needs a tuple. Remove the array or correct its length.");
    }
  }
}

// Copies the tuples named by `sources`, in that order, of all arrays.
template <typename Attributes>
void copyTuples(Attributes* data, vtkIdList* sources)
{
  const vtkIdType count = sources->GetNumberOfIds();
  vtkNew<Attributes> old;
  old->ShallowCopy(data);
  data->Initialize();
  data->CopyAllocate(old, count);
  data->CopyData(old, sources, consecutiveIds(0, count));
}
}

void copyPoints(
  vtkPolyData* input, const std::vector<std::int64_t>& copiedPoints, vtkPolyData* output)
{
  if (copiedPoints.empty())
  {
    return;
  }
  const vtkIdType before = input->GetNumberOfPoints();
  const auto sources = consecutiveIds(0, before + static_cast<vtkIdType>(copiedPoints.size()));
  std::copy(copiedPoints.begin(), copiedPoints.end(), sources->GetPointer(before));

  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(sources->GetNumberOfIds());
  input->GetPoints()->GetData()->GetTuples(sources, points->GetData());
  points->GetData()->SetName(input->GetPoints()->GetData()->GetName());
  output->SetPoints(points);
  checkLengths(output->GetPointData(), before, "point");
  copyTuples(output->GetPointData(), sources);
}

void setPolygons(const FacesFromVTK& mesh, const std::vector<std::int64_t>& connectivity,
  vtkPolyData* output, const Parallel& parallel)
{
  const CellSpan& cells = mesh.faces().cells;
  const auto faces = static_cast<vtkIdType>(cellCount(cells));
  if (mesh.hasStrips())
  {
    const vtkIdType others = output->GetNumberOfVerts() + output->GetNumberOfLines();
    const auto sources = consecutiveIds(0, others + faces);
    for (vtkIdType face = 0; face < faces; ++face)
    {
      sources->SetId(others + face, others + mesh.cellOf(face));
    }
    checkLengths(output->GetCellData(), output->GetNumberOfCells(), "cell");
    copyTuples(output->GetCellData(), sources);
    output->SetStrips(nullptr);
  }

  vtkNew<vtkCellArray> polygons;
  if (faces > 0)
  {
    const auto offsets = toArray(cells.offsets, Share(parallel, 0.0, 0.3));
    const bool isReplaced = !connectivity.empty();
    polygons->SetData(offsets,
      toArray(isReplaced ? IndexSpan{ connectivity.data(), true, connectivity.size() }
                         : cells.connectivity,
        Share(parallel, 0.3, 1.0)));
  }
  output->SetPolys(polygons);
  // Discard what the shallow copy shares with the input, and what described the old cells.
  output->DeleteCells();
  output->DeleteLinks();
}

void reversePolygons(vtkPolyData* output, const Parallel& parallel)
{
  vtkCellArray* polygons = output->GetPolys();
  forEachPart(parallel, static_cast<std::size_t>(polygons->GetNumberOfCells()),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        polygons->ReverseCellAtId(static_cast<vtkIdType>(i));
      }
    });
}
}
