// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HardMeshes.h"

#include "Meshes.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace
{
using Triple = std::array<double, 3>;

/// Random numbers, the same on every platform, which the standard's distributions do not guarantee.
class Random
{
public:
  double operator()() { return this->Engine() / 4294967296.0; }
  double operator()(double low, double high) { return low + (high - low) * (*this)(); }
  Triple direction()
  {
    const double z = (*this)(-1, 1), angle = (*this)(0, 6.283185307179586);
    const double r = std::sqrt(1 - z * z);
    return { r * std::cos(angle), r * std::sin(angle), z };
  }

private:
  std::mt19937 Engine{ 7 };
};

Triple moved(const Triple& p, const Triple& direction, double distance)
{
  return { p[0] + distance * direction[0], p[1] + distance * direction[1],
    p[2] + distance * direction[2] };
}

Triple faceNormal(const Triple& a, const Triple& b, const Triple& c)
{
  const Triple u{ b[0] - a[0], b[1] - a[1], b[2] - a[2] };
  const Triple v{ c[0] - a[0], c[1] - a[1], c[2] - a[2] };
  const Triple n{ u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  return { n[0] / length, n[1] / length, n[2] / length };
}

/// Adds a triangle with its own points.
void addFacet(MeshArrays& mesh, const Triple& a, const Triple& b, const Triple& c)
{
  const Triple normal = faceNormal(a, b, c);
  mesh.addPoint(a, normal);
  mesh.addPoint(b, normal);
  const vtkIdType last = mesh.addPoint(c, normal);
  mesh.addTriangle(last - 2, last - 1, last);
}

/// Adds `count` small facets around the origin, within `radius` on each axis.
void addCloud(MeshArrays& mesh, Random& random, std::size_t count, double radius, double size)
{
  for (std::size_t k = 0; k < count; ++k)
  {
    const Triple a{ random(-radius, radius), random(-radius, radius), random(-radius, radius) };
    const Triple b = moved(a, random.direction(), size);
    addFacet(mesh, a, b, moved(a, random.direction(), size));
  }
}

/// 384 triangles: twelve rings of sixteen points, and the poles.
void addSphere(MeshArrays& mesh, const Triple& center, double radius)
{
  constexpr int around = 16, rings = 12;
  const auto add = [&](double latitude, double longitude)
  {
    const Triple normal{ std::cos(latitude) * std::cos(longitude), std::sin(latitude),
      std::cos(latitude) * std::sin(longitude) };
    return mesh.addPoint(moved(center, normal, radius), normal);
  };
  constexpr double pi = 3.141592653589793;
  const vtkIdType south = add(-0.5 * pi, 0.0), north = add(0.5 * pi, 0.0), first = north + 1;
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int k = 0; k < around; ++k)
    {
      add(pi * ((ring + 1.0) / (rings + 1) - 0.5), -2.0 * pi * k / around);
    }
  }
  for (int k = 0; k < around; ++k)
  {
    const vtkIdType a = first + k, b = first + (k + 1) % around, top = (rings - 1) * around;
    mesh.addTriangle(south, b, a);
    mesh.addTriangle(north, a + top, b + top);
    for (vtkIdType ring = 0; ring < top; ring += around)
    {
      mesh.addTriangle(a + ring, b + ring, b + ring + around);
      mesh.addTriangle(a + ring, b + ring + around, a + ring + around);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> makeLayers()
{
  constexpr int layers = 64, n = 64;
  std::vector<int> order(layers);
  std::iota(order.begin(), order.end(), 0);
  Random random;
  for (int k = layers - 1; k > 0; --k)
  {
    std::swap(order[k], order[static_cast<int>(random(0, k + 1))]);
  }
  MeshArrays mesh;
  for (int layer : order)
  {
    const vtkIdType first = static_cast<vtkIdType>(mesh.points.size() / 3);
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        mesh.addPoint({ 2.0 * i / n - 1, 2.0 * j / n - 1,
          0.01 * layer + 0.002 * std::sin(0.5 * i + layer) * std::sin(0.5 * j) });
      }
    }
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const vtkIdType a = first + j * (n + 1) + i;
        mesh.addTriangle(a, a + 1, a + n + 2);
        mesh.addTriangle(a, a + n + 2, a + n + 1);
      }
    }
  }
  return mesh.toPolyData();
}

vtkSmartPointer<vtkPolyData> makeNeedles()
{
  Random random;
  MeshArrays mesh;
  for (int k = 0; k < 2000; ++k)
  {
    const double angle = random(0, 3.141592653589793), c = std::cos(angle), s = std::sin(angle);
    const double offset = random(-1, 1), depth = random(-0.1, 0.1), width = 0.0004;
    addFacet(mesh, { -c - offset * s, -s + offset * c, depth },
      { c - offset * s, s + offset * c, depth + random(-0.05, 0.05) },
      { -c - (offset + width) * s, -s + (offset + width) * c, depth });
  }
  return mesh.toPolyData();
}

vtkSmartPointer<vtkPolyData> makeOnePixel()
{
  Random random;
  MeshArrays mesh;
  // Two distant facets give the mesh its bounds, so that a pixel is about 0.003 wide.
  addFacet(mesh, { -1, -1, -1 }, { -0.9, -1, -1 }, { -1, -0.9, -1 });
  addFacet(mesh, { 1, 1, 1 }, { 0.9, 1, 1 }, { 1, 0.9, 1 });
  addCloud(mesh, random, 1000000, 0.001, 0.0005);
  return mesh.toPolyData();
}

vtkSmartPointer<vtkPolyData> makeSoup()
{
  Random random;
  MeshArrays mesh;
  constexpr std::size_t count = 10000000;
  mesh.points.reserve(9 * count);
  mesh.normals.reserve(9 * count);
  mesh.corners.reserve(3 * count);
  addCloud(mesh, random, count, 1.0, 0.01);
  return mesh.toPolyData();
}

vtkSmartPointer<vtkPolyData> makeCurtain()
{
  Random random;
  MeshArrays mesh;
  addCloud(mesh, random, 1000000, 1.0, 0.01);
  addFacet(mesh, { -1, -1, 1.1 }, { 1, -1, 1.1 }, { -1, 1, 1.1 });
  return mesh.toPolyData();
}

vtkSmartPointer<vtkPolyData> makeLate()
{
  Random random;
  MeshArrays mesh;
  addCloud(mesh, random, 2000000, 1.0, 0.00001);
  addCloud(mesh, random, 2000, 1.0, 0.5);
  return mesh.toPolyData();
}

vtkSmartPointer<vtkPolyData> makeBalls()
{
  Random random;
  vtkNew<vtkPoints> points;
  for (int k = 0; k < 1000000; ++k)
  {
    const double x = random(-1, 1), y = random(-1, 1), z = random(-1, 1);
    points->InsertNextPoint(x, y, z);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  return result;
}

vtkSmartPointer<vtkPolyData> makeLines()
{
  constexpr double length = 0.1;
  Random random;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (vtkIdType k = 0; k < 100000; ++k)
  {
    const double x = random(-1, 1), y = random(-1, 1), z = random(-1, 1);
    const Triple end = moved({ x, y, z }, random.direction(), length);
    points->InsertNextPoint(x, y, z);
    points->InsertNextPoint(end.data());
    const vtkIdType ids[2] = { 2 * k, 2 * k + 1 };
    lines->InsertNextCell(2, ids);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetLines(lines);
  return result;
}

vtkSmartPointer<vtkPolyData> makeBox()
{
  constexpr Triple corners[8] = { { -1, -1, -1 }, { 1, -1, -1 }, { -1, 1, -1 }, { 1, 1, -1 },
    { -1, -1, 1 }, { 1, -1, 1 }, { -1, 1, 1 }, { 1, 1, 1 } };
  constexpr int faces[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
    { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };
  MeshArrays mesh;
  for (const auto& face : faces)
  {
    addFacet(mesh, corners[face[0]], corners[face[1]], corners[face[2]]);
    addFacet(mesh, corners[face[0]], corners[face[2]], corners[face[3]]);
  }
  return mesh.toPolyData();
}

vtkSmartPointer<vtkPolyData> makeFacets()
{
  Random random;
  MeshArrays mesh;
  addCloud(mesh, random, 100000, 1.0, 0.02);
  return mesh.toPolyData();
}

vtkSmartPointer<vtkPolyData> makeSpheres()
{
  Random random;
  MeshArrays mesh;
  for (int k = 0; k < 3000; ++k)
  {
    const double x = random(-1, 1), y = random(-1, 1);
    addSphere(mesh, { x, y, random(-1, 1) }, 0.05);
  }
  return mesh.toPolyData();
}
