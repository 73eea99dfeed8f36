// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlyVertices.h"
#include "PlyWalk.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <vector>

namespace lambent::command
{
namespace
{

/// Collects coordinates and normals from the properties x, y, z, nx, ny and nz.
template <typename PointArray>
struct VertexSink
{
  std::vector<int> slotOfProperty; ///< 0..5, or 6 for properties that are skipped
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
void ReadVertices(PlyCursor& cursor, const PlyElement& element,
  const std::function<void(double)>& progress, vtkPolyData* mesh)
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
  mesh->GetPointData()->SetNormals(nullptr); // drop those of an earlier element "vertex"
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

bool HasDoubleCoordinates(const PlyElement& element)
{
  const std::size_t x = Find(element, "x");
  return x < element.properties.size() && element.properties[x].type == PlyType::Float64;
}

} // namespace

void ReadPlyVertices(PlyCursor& cursor, const PlyElement& element,
  const std::function<void(double)>& progress, vtkPolyData* mesh)
{
  const bool isDouble = HasDoubleCoordinates(element);
  (isDouble ? ReadVertices<vtkDoubleArray> : ReadVertices<vtkFloatArray>)(cursor, element, progress,
    mesh);
}

} // namespace lambent::command
