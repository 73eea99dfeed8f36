// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief meshes for tests, with double points
 */
#ifndef Meshes_h
#define Meshes_h

#include "Studio.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cmath>
#include <vector>

using Polygons = std::vector<std::vector<vtkIdType>>;
using Mesh = vtkSmartPointer<vtkPolyData>;

inline vtkSmartPointer<vtkDoubleArray> makeTuples(const std::vector<Vec>& tuples, const char* name)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(3);
  for (const Vec& tuple : tuples)
  {
    array->InsertNextTuple(&tuple.x);
  }
  return array;
}

inline vtkSmartPointer<vtkCellArray> makeCells(const Polygons& polygons)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& ids : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return cells;
}

inline Mesh makeMesh(const std::vector<Vec>& points, const Polygons& polygons)
{
  vtkNew<vtkPoints> vtkpoints;
  vtkpoints->SetData(makeTuples(points, "Points"));
  Mesh mesh = Mesh::New();
  mesh->SetPoints(vtkpoints);
  mesh->SetPolys(makeCells(polygons));
  return mesh;
}

inline void setPointNormals(vtkPolyData* mesh, const std::vector<Vec>& normals)
{
  mesh->GetPointData()->SetNormals(makeTuples(normals, "PointNormals"));
}

inline void setCellNormals(vtkPolyData* mesh, const std::vector<Vec>& normals)
{
  mesh->GetCellData()->SetNormals(makeTuples(normals, "CellNormals"));
}

inline std::vector<Vec> pointsOf(vtkPolyData* mesh)
{
  std::vector<Vec> points(mesh->GetNumberOfPoints());
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    mesh->GetPoint(static_cast<vtkIdType>(p), &points[p].x);
  }
  return points;
}

/// The square |x|, |y| <= size at height z, facing +z.
inline Mesh makeSquare(double size = 100.0, double z = 0.0)
{
  return makeMesh(
    { { -size, -size, z }, { size, -size, z }, { size, size, z }, { -size, size, z } },
    { { 0, 1, 2, 3 } });
}

/// |x| <= a, |y| <= b, |z| <= c, facing outwards.
inline Mesh makeBox(double a, double b, double c)
{
  std::vector<Vec> corners;
  for (int k = 0; k < 8; ++k)
  {
    corners.emplace_back(k & 1 ? a : -a, k & 2 ? b : -b, k & 4 ? c : -c);
  }
  return makeMesh(corners,
    { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
      { 4, 5, 7, 6 } });
}

/// The lateral surface of a cylinder of n facets around the y axis, radius 1, |y| <= 1. Edge k
/// lies at angle 2 pi k / n from z towards x. Point normals point outwards.
inline Mesh makeCylinder(int n)
{
  std::vector<Vec> points, normals;
  Polygons facets;
  for (int k = 0; k < n; ++k)
  {
    const double angle = 2.0 * pi * k / n;
    const Vec normal(std::sin(angle), 0.0, std::cos(angle));
    points.push_back(normal - Vec(0.0, 1.0, 0.0));
    points.push_back(normal + Vec(0.0, 1.0, 0.0));
    normals.insert(normals.end(), 2, normal);
    const vtkIdType a = 2 * k, b = 2 * ((k + 1) % n);
    facets.push_back({ a, b, b + 1, a + 1 });
  }
  Mesh mesh = makeMesh(points, facets);
  setPointNormals(mesh, normals);
  return mesh;
}

/// A closed sphere of triangles, radius 1, with its exact normals; n intervals along a
/// meridian, 2n along the equator.
inline Mesh makeSphere(int n)
{
  std::vector<Vec> points{ { 0.0, 1.0, 0.0 }, { 0.0, -1.0, 0.0 } };
  Polygons triangles;
  const auto id = [n](int ring, int k) -> vtkIdType {
    return ring == 0 ? 0 : ring == n ? 1 : 2 + (ring - 1) * 2 * n + k % (2 * n);
  };
  for (int ring = 1; ring < n; ++ring)
  {
    for (int k = 0; k < 2 * n; ++k)
    {
      const double polar = pi * ring / n, angle = pi * k / n;
      points.emplace_back(
        std::sin(polar) * std::sin(angle), std::cos(polar), std::sin(polar) * std::cos(angle));
    }
  }
  for (int ring = 0; ring < n; ++ring)
  {
    for (int k = 0; k < 2 * n; ++k)
    {
      if (ring > 0)
      {
        triangles.push_back({ id(ring, k), id(ring + 1, k), id(ring, k + 1) });
      }
      if (ring < n - 1)
      {
        triangles.push_back({ id(ring + 1, k), id(ring + 1, k + 1), id(ring, k + 1) });
      }
    }
  }
  Mesh mesh = makeMesh(points, triangles);
  setPointNormals(mesh, points);
  return mesh;
}

/// n x n unit squares, each divided into two triangles, with points at integer offsets from
/// (x0, y0).
inline Mesh makeGrid(int n, double x0, double y0)
{
  std::vector<Vec> points;
  Polygons triangles;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      points.emplace_back(x0 + i, y0 + j, 0.0);
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const vtkIdType a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
      triangles.push_back({ a, b, c });
      triangles.push_back({ a, c, d });
    }
  }
  return makeMesh(points, triangles);
}

#endif
