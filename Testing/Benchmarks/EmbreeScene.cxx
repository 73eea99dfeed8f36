// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmbreeScene.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <stdexcept>

namespace
{
constexpr std::size_t padding = 4;

std::vector<float> padded(vtkDataArray* tuples)
{
  auto* floats = vtkFloatArray::SafeDownCast(tuples);
  if (!floats)
  {
    throw std::runtime_error("the benchmark's meshes have points and normals of floats");
  }
  const float* begin = floats->GetPointer(0);
  std::vector<float> values(begin, begin + floats->GetNumberOfValues());
  values.resize(values.size() + padding);
  return values;
}

std::vector<std::uint32_t> padded(vtkCellArray* triangles)
{
  if (triangles->GetNumberOfConnectivityIds() != 3 * triangles->GetNumberOfCells())
  {
    throw std::runtime_error("the benchmark's meshes have triangles alone");
  }
  vtkDataArray* corners = triangles->GetConnectivityArray();
  const std::size_t count = static_cast<std::size_t>(corners->GetNumberOfValues());
  std::vector<std::uint32_t> values(count + padding);
  for (std::size_t i = 0; i < count; ++i)
  {
    values[i] = static_cast<std::uint32_t>(corners->GetComponent(static_cast<vtkIdType>(i), 0));
  }
  return values;
}

Float3 toFloats(const Triple& triple)
{
  return { static_cast<float>(triple[0]), static_cast<float>(triple[1]),
    static_cast<float>(triple[2]) };
}
}

EmbreeMesh::EmbreeMesh(vtkPolyData* polyData)
  : points(padded(polyData->GetPoints()->GetData()))
  , normals(padded(polyData->GetPointData()->GetNormals()))
  , corners(padded(polyData->GetPolys()))
{
}

EmbreeView::EmbreeView(const View& view)
  : eye(toFloats(view.eye))
  , right(toFloats(view.right))
  , up(toFloats(view.up))
  , forward(toFloats(view.forward))
  , light(toFloats(
      { view.light[0] - view.eye[0], view.light[1] - view.eye[1], view.light[2] - view.eye[2] }))
  , pixel(static_cast<float>(view.pixel))
  , parallel(view.parallel)
{
}
