// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkRTAnalyticSource.h"
#include "vtkTriangleMeshPointNormals.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>

namespace
{
vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleMeshPointNormals> normals;
  normals->SetInputData(mesh);
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkFloatArray> tuples(const std::vector<float>& values)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 3));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

void write(vtkPolyData* mesh, const std::string& path)
{
  const std::string unfinished = path + ".part";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(unfinished.c_str());
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  writer->SetHeaderTypeToUInt64();
  if (writer->Write())
  {
    std::rename(unfinished.c_str(), path.c_str());
  }
}

/// Returns only points, triangles and point normals.
vtkSmartPointer<vtkPolyData> contourWave(int half)
{
  vtkNew<vtkRTAnalyticSource> source;
  source->SetWholeExtent(-half, half, -half, half, -half, half);
  source->SetXFreq(600.0 / half);
  source->SetYFreq(300.0 / half);
  source->SetZFreq(400.0 / half);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputConnection(source->GetOutputPort());
  contour->SetValue(0, 120);
  contour->ComputeNormalsOn();
  contour->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(contour->GetOutput()->GetPoints());
  mesh->SetPolys(contour->GetOutput()->GetPolys());
  mesh->GetPointData()->SetNormals(contour->GetOutput()->GetPointData()->GetNormals());
  return mesh;
}

using Triple = std::array<double, 3>;

/// A point on the ball over the point (u, v) in the square [-1, 1]^2 of a cube's face.
Triple onBall(int face, double u, double v)
{
  constexpr double eighth = 0.7853981633974483; // of a full turn
  const int axis = face / 2;
  const double side = face % 2 ? 1.0 : -1.0;
  Triple p;
  p[axis] = side;
  p[(axis + 1) % 3] = side * std::tan(eighth * u);
  p[(axis + 2) % 3] = std::tan(eighth * v);
  const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  p = { p[0] / length, p[1] / length, p[2] / length };
  const double radius = 1 + 0.06 * std::sin(9 * p[0]) * std::sin(11 * p[1]) * std::sin(10 * p[2]) +
    0.012 * std::sin(47 * p[0] + 31 * p[1]) * std::sin(43 * p[2] - 19 * p[1]);
  return { radius * p[0], radius * p[1], radius * p[2] };
}

Triple normalOnBall(int face, double u, double v)
{
  constexpr double h = 1e-5;
  const Triple u0 = onBall(face, u - h, v), u1 = onBall(face, u + h, v);
  const Triple v0 = onBall(face, u, v - h), v1 = onBall(face, u, v + h);
  const Triple a{ u1[0] - u0[0], u1[1] - u0[1], u1[2] - u0[2] };
  const Triple b{ v1[0] - v0[0], v1[1] - v0[1], v1[2] - v0[2] };
  Triple normal;
  vtkMath::Cross(a.data(), b.data(), normal.data());
  vtkMath::Normalize(normal.data());
  return normal;
}
}

//------------------------------------------------------------------------------
vtkIdType MeshArrays::addPoint(const std::array<double, 3>& point)
{
  for (double coordinate : point)
  {
    this->points.push_back(static_cast<float>(coordinate));
  }
  return static_cast<vtkIdType>(this->points.size() / 3 - 1);
}

vtkIdType MeshArrays::addPoint(
  const std::array<double, 3>& point, const std::array<double, 3>& normal)
{
  for (double coordinate : normal)
  {
    this->normals.push_back(static_cast<float>(coordinate));
  }
  return this->addPoint(point);
}

void MeshArrays::addTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
{
  this->corners.insert(this->corners.end(), { a, b, c });
}

vtkSmartPointer<vtkPolyData> MeshArrays::toPolyData()
{
  vtkNew<vtkPoints> meshPoints;
  meshPoints->SetData(tuples(this->points));
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(this->corners.size()));
  std::copy(this->corners.begin(), this->corners.end(), connectivity->GetPointer(0));
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, connectivity);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(meshPoints);
  mesh->SetPolys(cells);
  if (this->normals.empty())
  {
    return withNormals(mesh);
  }
  mesh->GetPointData()->SetNormals(tuples(this->normals));
  return mesh;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> readMesh(const std::string& path)
{
  if (!std::filesystem::exists(path))
  {
    return nullptr;
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return withNormals(reader->GetOutput());
}

vtkSmartPointer<vtkPolyData> makeWave(int half, const std::string& cache)
{
  const std::string path = cache + "/wave-" + std::to_string(half) + ".vtp";
  if (std::filesystem::exists(path))
  {
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return reader->GetOutput();
  }
  std::cerr << "Contouring the wave of " << half << " once, into " << path << " ...\n";
  const auto mesh = contourWave(half);
  std::filesystem::create_directories(cache);
  write(mesh, path);
  return mesh;
}

vtkSmartPointer<vtkPolyData> makeBumps(std::size_t triangles)
{
  // The six faces of a cube, with n x n x 2 triangles each, inflated to a ball.
  const int n = std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 12.0))));
  MeshArrays mesh;
  for (int face = 0; face < 6; ++face)
  {
    const vtkIdType first = static_cast<vtkIdType>(mesh.points.size() / 3);
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        const double u = 2.0 * i / n - 1, v = 2.0 * j / n - 1;
        mesh.addPoint(onBall(face, u, v), normalOnBall(face, u, v));
      }
    }
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const vtkIdType a = first + static_cast<vtkIdType>(j) * (n + 1) + i;
        mesh.addTriangle(a, a + 1, a + n + 2);
        mesh.addTriangle(a, a + n + 2, a + n + 1);
      }
    }
  }
  return mesh.toPolyData();
}
