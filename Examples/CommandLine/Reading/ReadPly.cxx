// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReadPly.h"
#include "CheckFile.h"
#include "FileBytes.h"
#include "Messages.h"
#include "PlyCursor.h"
#include "PlyHeader.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <limits>

namespace lambent::command
{
namespace
{

using ProgressFunction = std::function<void(double)>;

std::size_t Find(const PlyElement& element, const std::string& name)
{
  const auto found = std::find_if(element.properties.begin(), element.properties.end(),
    [&name](const PlyProperty& property) { return property.name == name; });
  return static_cast<std::size_t>(found - element.properties.begin());
}

/// Goes through an element: for each item, for each of its properties, sink.Begin(property,
/// number of values) and sink.Value(property, value) for each value; then sink.EndItem().
template <typename Sink>
void Walk(
  PlyCursor& cursor, const PlyElement& element, const ProgressFunction& progress, Sink& sink)
{
  std::size_t item = 0;
  const auto require = [&](bool isThere)
  {
    if (!isThere)
    {
      throw Failure("it is cut short: it ends within " + element.name + " " + std::to_string(item) +
        " of " + std::to_string(element.count));
    }
  };
  for (; item < element.count && !element.properties.empty(); ++item)
  {
    for (std::size_t p = 0; p < element.properties.size(); ++p)
    {
      const PlyProperty& property = element.properties[p];
      double count = 1;
      require(!property.isList ||
        (cursor.Next(property.countType, count) && cursor.CanHold(count, property.type)));
      sink.Begin(p, count);
      for (double k = 0; k < count; ++k)
      {
        double value;
        require(cursor.Next(property.type, value));
        sink.Value(p, value);
      }
    }
    sink.EndItem();
    if (item % 65536 == 0)
    {
      progress(static_cast<double>(item) / static_cast<double>(element.count));
    }
  }
}

struct SkipSink
{
  void Begin(std::size_t, double) {}
  void Value(std::size_t, double) {}
  void EndItem() {}
};

/// Takes coordinates and normals, in the order x y z nx ny nz, from the properties of that name.
template <typename PointArray>
struct VertexSink
{
  std::vector<int> slotOfProperty; ///< 0..5, or 6 for what is passed over
  std::array<double, 7> row{};
  PointArray* points;
  vtkFloatArray* normals; ///< null if there are none

  void Begin(std::size_t, double) {}
  void Value(std::size_t property, double value) { this->row[slotOfProperty[property]] = value; }
  void EndItem()
  {
    for (int i = 0; i < 3; ++i)
    {
      using Coordinate = typename PointArray::ValueType;
      this->points->InsertNextValue(static_cast<Coordinate>(this->row[i]));
      if (this->normals)
      {
        this->normals->InsertNextValue(static_cast<float>(this->row[3 + i]));
      }
    }
  }
};

template <typename PointArray>
void ReadVertices(
  PlyCursor& cursor, const PlyElement& element, const ProgressFunction& progress, vtkPolyData* mesh)
{
  VertexSink<PointArray> sink;
  sink.slotOfProperty.assign(element.properties.size(), 6);
  const char* const names[] = { "x", "y", "z", "nx", "ny", "nz" };
  bool has[6];
  for (int i = 0; i < 6; ++i)
  {
    const std::size_t property = Find(element, names[i]);
    has[i] = property < element.properties.size();
    if (has[i])
    {
      sink.slotOfProperty[property] = i;
    }
  }
  if (!(has[0] && has[1] && has[2]))
  {
    throw Failure("its vertices have no x, y and z");
  }

  const auto size = static_cast<vtkIdType>(3 * element.count);
  vtkNew<PointArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->Allocate(size);
  sink.points = coordinates;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetName("Normals");
  sink.normals = has[3] && has[4] && has[5] ? normals.Get() : nullptr;
  if (sink.normals)
  {
    normals->Allocate(size);
    mesh->GetPointData()->SetNormals(normals);
  }
  Walk(cursor, element, progress, sink);
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  mesh->SetPoints(points);
}

/// Takes the vertex lists of the faces.
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
          " names a vertex that does not exist");
      }
      this->connectivity->InsertNextValue(static_cast<Id>(value));
    }
  }
  void EndItem() {}
};

template <typename IdArray>
void ReadFaces(
  PlyCursor& cursor, const PlyElement& element, const ProgressFunction& progress, vtkPolyData* mesh)
{
  FaceSink<IdArray> sink;
  sink.list = std::min(Find(element, "vertex_indices"), Find(element, "vertex_index"));
  if (sink.list == element.properties.size() || !element.properties[sink.list].isList)
  {
    throw Failure("its faces have no list 'vertex_indices'");
  }
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

/// A count is believed only if the rest of the file can hold it: memory is taken by it.
void CheckCount(const PlyCursor& cursor, const PlyElement& element)
{
  for (const PlyProperty& property : element.properties)
  {
    const PlyType first = property.isList ? property.countType : property.type;
    if (!cursor.CanHold(static_cast<double>(element.count), first))
    {
      throw Failure("it is cut short: its header promises " + std::to_string(element.count) +
        " of '" + element.name + "', more than the rest of the file can hold");
    }
  }
}

bool HasDoubleCoordinates(const PlyElement& element)
{
  const std::size_t x = Find(element, "x");
  return x < element.properties.size() && element.properties[x].type == PlyType::Float64;
}

} // namespace

vtkSmartPointer<vtkPolyData> ReadPly(const std::string& path, const ProgressFunction& progress)
{
  const FileBytes file(path);
  const PlyHeader header = ParsePlyHeader(file.view());
  if (header.format == PlyFormat::Text)
  {
    CheckLastByte(file.view().back());
  }
  PlyCursor cursor(file.begin() + header.bodyOffset, file.end(), header.format);
  // A file of less than 2 GB cannot hold more than 2^31 - 1 ids; they then take half the room.
  const bool idsAreShort = file.size() <= std::numeric_limits<vtkTypeInt32>::max();

  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  for (const PlyElement& element : header.elements)
  {
    CheckCount(cursor, element);
    if (element.name == "vertex")
    {
      const bool isDouble = HasDoubleCoordinates(element);
      (isDouble ? ReadVertices<vtkDoubleArray> : ReadVertices<vtkFloatArray>)(cursor, element,
        progress, mesh);
    }
    else if (element.name == "face")
    {
      (idsAreShort ? ReadFaces<vtkTypeInt32Array> : ReadFaces<vtkTypeInt64Array>)(cursor, element,
        progress, mesh);
    }
    else
    {
      SkipSink sink;
      Walk(cursor, element, progress, sink);
    }
  }
  if (!mesh->GetPoints())
  {
    throw Failure("it has no vertices");
  }
  return mesh;
}

} // namespace lambent::command
