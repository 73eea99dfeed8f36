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
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <vector>

namespace lambent::command
{
namespace
{

constexpr const char* Names[] = { "x", "y", "z", "nx", "ny", "nz", "red", "green", "blue",
  "alpha" };
constexpr int FirstNormal = 3, FirstColor = 6, Alpha = 9, Skipped = 10;

/// Collects coordinates, normals and colours.
template <typename PointArray>
struct VertexSink
{
  std::vector<int> slotOfProperty; ///< the index of its name, or Skipped
  std::array<double, Skipped + 1> row{};
  PointArray* points;
  vtkFloatArray* normals;       ///< null if there are none
  vtkUnsignedCharArray* colors; ///< null if there are none
  double colorScale = 1;        ///< what 1 stands for, in bytes

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
        this->normals->InsertNextValue(static_cast<float>(this->row[FirstNormal + i]));
      }
    }
    for (int i = 0; this->colors && i < this->colors->GetNumberOfComponents(); ++i)
    {
      const double byte = this->colorScale * this->row[FirstColor + i] + 0.5;
      this->colors->InsertNextValue(
        byte >= 1 ? static_cast<unsigned char>(std::min(byte, 255.0)) : 0); // NaN gives 0
    }
  }
};

/// How many bytes a value of 1 is in colours of that type: colours are bytes, or floats from 0 to
/// 1. Other types are not colours: 0.
double ColorScaleOf(PlyType type)
{
  return type == PlyType::UInt8                            ? 1
    : type == PlyType::Float32 || type == PlyType::Float64 ? 255
                                                           : 0;
}

/// The components of the colours, 3 or 4, or 0 if there are none. Sets their scale.
int ColorsOf(const PlyElement& element, double& scale)
{
  int count = 0;
  for (; FirstColor + count <= Alpha; ++count)
  {
    const std::size_t property = Find(element, Names[FirstColor + count]);
    const bool isColor = property < element.properties.size() &&
      !element.properties[property].isList && ColorScaleOf(element.properties[property].type) > 0;
    const double own = isColor ? ColorScaleOf(element.properties[property].type) : 0;
    if (!isColor || (count > 0 && own != scale))
    {
      break;
    }
    scale = own;
  }
  return count >= 3 ? count : 0;
}

/// An empty array of the points, with room for all vertices, or none.
template <typename Array>
vtkSmartPointer<Array> MakeArray(const PlyElement& element, int components, const char* name)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->Allocate(static_cast<vtkIdType>(components * element.count));
  return array;
}

template <typename PointArray>
void ReadVertices(PlyCursor& cursor, const PlyElement& element,
  const std::function<void(double)>& progress, vtkPolyData* mesh)
{
  VertexSink<PointArray> sink;
  sink.slotOfProperty.assign(element.properties.size(), Skipped);
  bool has[Skipped];
  for (int i = 0; i < Skipped; ++i)
  {
    const std::size_t property = Find(element, Names[i]);
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

  const auto coordinates = MakeArray<PointArray>(element, 3, nullptr);
  sink.points = coordinates;
  vtkPointData* const data = mesh->GetPointData();
  data->Initialize(); // drop the arrays of an earlier element "vertex"
  vtkSmartPointer<vtkFloatArray> normals;
  if (has[3] && has[4] && has[5])
  {
    normals = MakeArray<vtkFloatArray>(element, 3, "Normals");
    data->SetNormals(normals);
  }
  vtkSmartPointer<vtkUnsignedCharArray> colors;
  if (const int components = ColorsOf(element, sink.colorScale))
  {
    colors = MakeArray<vtkUnsignedCharArray>(element, components, components == 4 ? "RGBA" : "RGB");
    data->SetScalars(colors);
  }
  sink.normals = normals;
  sink.colors = colors;
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
