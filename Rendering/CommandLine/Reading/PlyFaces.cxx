// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlyFaces.h"
#include "CellLists.h"
#include "PlyWalk.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <limits>

namespace lambent::command
{
namespace
{

std::size_t FindVertexList(const PlyElement& element, const std::string& what)
{
  const std::size_t list = std::min(Find(element, "vertex_indices"), Find(element, "vertex_index"));
  if (list == element.properties.size() || !element.properties[list].isList)
  {
    throw Failure("its " + what + " have no list 'vertex_indices'");
  }
  return list;
}

/// Collects the vertex lists of the faces.
template <typename IdArray>
struct FaceSink
{
  std::size_t list; ///< the property that holds them
  IdArray* offsets;
  IdArray* connectivity;

  using Id = typename IdArray::ValueType;

  void Begin(std::size_t property, double)
  {
    if (property == this->list)
    {
      this->offsets->InsertNextValue(static_cast<Id>(this->connectivity->GetNumberOfValues()));
    }
  }
  void Value(std::size_t property, double value)
  {
    if (property == this->list)
    {
      if (!(value >= 0 && value <= std::numeric_limits<vtkTypeInt32>::max()))
      {
        throw Failure("face " + std::to_string(this->offsets->GetNumberOfValues() - 1) +
          " uses a vertex that does not exist");
      }
      this->connectivity->InsertNextValue(static_cast<Id>(value));
    }
  }
  void EndItem() {}
};

template <typename IdArray>
void ReadFaces(PlyCursor& cursor, const PlyElement& element,
  const std::function<void(double)>& progress, vtkPolyData* mesh)
{
  FaceSink<IdArray> sink;
  sink.list = FindVertexList(element, "faces");
  vtkNew<IdArray> offsets;
  vtkNew<IdArray> connectivity;
  offsets->Allocate(static_cast<vtkIdType>(element.count + 1));
  connectivity->Allocate(static_cast<vtkIdType>(3 * element.count));
  sink.offsets = offsets;
  sink.connectivity = connectivity;
  Walk(cursor, element, progress, sink);
  offsets->InsertNextValue(
    static_cast<typename IdArray::ValueType>(connectivity->GetNumberOfValues()));
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  mesh->SetPolys(polygons);
}

/// Collects the strips from the lists.
struct StripSink
{
  std::size_t list; ///< the property that holds them
  CellLists strips;
  std::size_t tooShort = 0;

  void Begin(std::size_t, double) {}
  void Value(std::size_t property, double value)
  {
    constexpr double minusOneAsUnsigned = 4294967295.0;
    if (property != this->list)
    {
      return;
    }
    if (value == -1 || value == minusOneAsUnsigned)
    {
      this->EndItem();
      return;
    }
    if (!(value >= 0 && value <= std::numeric_limits<std::int32_t>::max()))
    {
      throw Failure("triangle strip " + std::to_string(this->strips.size()) +
        " uses a vertex that does not exist");
    }
    this->strips.points.push_back(static_cast<std::int32_t>(value));
  }
  void EndItem()
  {
    const std::size_t begin = static_cast<std::size_t>(this->strips.offsets.back());
    const std::size_t points = this->strips.points.size() - begin;
    if (points >= 3)
    {
      this->strips.EndCell();
      return;
    }
    this->strips.points.resize(begin);
    this->tooShort += points > 0;
  }
};

} // namespace

void ReadPlyFaces(PlyCursor& cursor, const PlyElement& element, bool idsAreShort,
  const std::function<void(double)>& progress, vtkPolyData* mesh)
{
  (idsAreShort ? ReadFaces<vtkTypeInt32Array> : ReadFaces<vtkTypeInt64Array>)(cursor, element,
    progress, mesh);
}

void ReadPlyStrips(PlyCursor& cursor, const PlyElement& element,
  const std::function<void(double)>& progress, vtkPolyData* mesh)
{
  StripSink sink;
  sink.list = FindVertexList(element, "triangle strips");
  Walk(cursor, element, progress, sink);
  if (sink.tooShort > 0)
  {
    vtkGenericWarningMacro(<< "triangle strips of fewer than 3 points are skipped; it has "
                           << sink.tooShort << " of them");
  }
  mesh->SetStrips(MakeCellArray(sink.strips));
}

} // namespace lambent::command
