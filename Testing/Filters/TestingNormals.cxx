// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TestingNormals.h"

#include "CornerAngles.h"
#include "vtkLambentNormals.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkIdList.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

Vector operator-(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vector operator*(const Vector& a, double factor)
{
  return { a[0] * factor, a[1] * factor, a[2] * factor };
}

double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Vector unit(const Vector& a)
{
  return a * (1.0 / std::sqrt(dot(a, a)));
}

vtkSmartPointer<vtkPolyData> makeMesh(
  const std::vector<Vector>& points, const std::vector<Face>& polygons)
{
  vtkNew<vtkPoints> meshPoints;
  meshPoints->SetDataTypeToDouble();
  for (const Vector& p : points)
  {
    meshPoints->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> cells;
  for (const Face& face : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(face.size()), face.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(meshPoints);
  mesh->SetPolys(cells);
  return mesh;
}

vtkSmartPointer<vtkPolyData> makeCube()
{
  std::vector<Vector> points; // point i has the coordinates of the bits of i
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ 1.0 * (i & 1), 1.0 * (i >> 1 & 1), 1.0 * (i >> 2) });
  }
  return makeMesh(points,
    { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 2, 3, 1 },
      { 4, 5, 7, 6 } });
}

vtkSmartPointer<vtkPolyData> makeRandomMesh(const RandomMeshOptions& options)
{
  std::mt19937 random(options.seed);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  std::uniform_int_distribution<vtkIdType> anyPoint(0, options.points - 1);
  std::uniform_int_distribution<vtkIdType> step(-40, 40);

  vtkNew<vtkPoints> points;
  points->SetDataType(options.floatPoints ? VTK_FLOAT : VTK_DOUBLE);
  for (int i = 0; i < options.points; ++i)
  {
    points->InsertNextPoint(coordinate(random), coordinate(random), coordinate(random));
  }
  // Mostly points close to each other, as in a mesh, but sometimes from anywhere.
  const auto makeCells = [&](std::initializer_list<int> sizes)
  {
    vtkNew<vtkCellArray> cells;
    options.use64BitCells ? cells->Use64BitStorage() : cells->Use32BitStorage();
    for (int i = 0; i < options.cells; ++i)
    {
      const vtkIdType around = anyPoint(random);
      Face face(sizes.begin()[random() % sizes.size()]);
      for (vtkIdType& point : face)
      {
        point = random() % 50 == 0
          ? anyPoint(random)
          : std::clamp<vtkIdType>(around + step(random), 0, options.points - 1);
      }
      cells->InsertNextCell(static_cast<vtkIdType>(face.size()), face.data());
    }
    return vtkSmartPointer<vtkCellArray>(cells);
  };
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetVerts(makeCells({ 1, 2 }));
  mesh->SetLines(makeCells({ 2, 5 }));
  mesh->SetPolys(makeCells({ 3, 3, 3, 4, 5, 9, 2 }));
  mesh->SetStrips(makeCells({ 3, 4, 7, 8 }));
  return mesh;
}

std::vector<Face> facesOf(vtkPolyData* mesh)
{
  std::vector<Face> faces;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    mesh->GetPolys()->GetCellAtId(i, ids);
    faces.emplace_back(ids->begin(), ids->end());
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfStrips(); ++i)
  {
    mesh->GetStrips()->GetCellAtId(i, ids);
    for (vtkIdType k = 0; k + 2 < ids->GetNumberOfIds(); ++k)
    {
      Face triangle{ ids->GetId(k), ids->GetId(k + 1), ids->GetId(k + 2) };
      if (k % 2 == 1)
      {
        std::swap(triangle[0], triangle[1]);
      }
      faces.push_back(triangle);
    }
  }
  return faces;
}

Vector pointOf(vtkPolyData* mesh, vtkIdType point)
{
  Vector p;
  mesh->GetPoint(point, p.data());
  return p;
}

namespace
{
Face withoutRepetitions(const Face& face)
{
  Face result;
  for (vtkIdType point : face)
  {
    if (result.empty() || result.back() != point)
    {
      result.push_back(point);
    }
  }
  while (result.size() > 1 && result.back() == result.front())
  {
    result.pop_back();
  }
  return result;
}

Vector areaVector(const std::vector<Vector>& corners)
{
  Vector sum{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    const Vector term = cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    sum = { sum[0] + term[0], sum[1] + term[1], sum[2] + term[2] };
  }
  return sum;
}

// The angles of a triangle are computed together, others one by one.
double angleAt(const std::vector<Vector>& corners, const Vector& area, std::size_t i)
{
  const std::size_t n = corners.size();
  const auto edge = [&](std::size_t from, std::size_t to)
  { return corners[to % n] - corners[from % n]; };
  const auto product = [&](std::size_t k) { return dot(edge(k, k + 1), edge(k, k + n - 1)); };
  if (n == 3)
  {
    const lambent::TriangleAngles angles =
      lambent::anglesOf(std::sqrt(dot(area, area)), product(0), product(1), product(2));
    return i == 0 ? angles.a : (i == 1 ? angles.b : angles.c);
  }
  const Vector corner = cross(edge(i, i + 1), edge(i, i + n - 1));
  const double angle = lambent::angleOf(std::sqrt(dot(corner, corner)), product(i));
  return dot(corner, area) < 0.0 ? 6.283185307179586 - angle : angle;
}

Vector contribution(
  int weighting, const std::vector<Vector>& corners, const Vector& area, std::size_t i)
{
  const std::size_t n = corners.size();
  const Vector normal = area * (1.0 / std::sqrt(dot(area, area)));
  const Vector u = corners[(i + 1) % n] - corners[i];
  const Vector v = corners[(i + n - 1) % n] - corners[i];
  const Vector corner = n == 3 ? area : cross(u, v);
  const double squares = dot(u, u) * dot(v, v);
  switch (weighting)
  {
    case vtkLambentNormals::UNIFORM:
      return normal;
    case vtkLambentNormals::AREA:
      return area;
    case vtkLambentNormals::MAX:
      return squares > 0.0 ? corner * ((dot(corner, area) < 0.0 ? -1.0 : 1.0) / squares) : Vector{};
    default:
      return squares > 0.0 ? normal * angleAt(corners, area, i) : Vector{};
  }
}
}

std::vector<float> referenceNormals(vtkPolyData* mesh, int weighting)
{
  std::vector<Vector> sums(mesh->GetNumberOfPoints(), Vector{ 0.0, 0.0, 0.0 });
  for (const Face& named : facesOf(mesh))
  {
    const Face face = withoutRepetitions(named);
    std::vector<Vector> corners;
    for (vtkIdType point : face)
    {
      corners.push_back(pointOf(mesh, point));
    }
    const Vector area = areaVector(corners);
    if (!(dot(area, area) > 0.0 && std::isfinite(dot(area, area))))
    {
      continue;
    }
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const Vector term = contribution(weighting, corners, area, i);
      Vector& sum = sums[face[i]];
      sum = { sum[0] + term[0], sum[1] + term[1], sum[2] + term[2] };
    }
  }
  std::vector<float> normals;
  for (const Vector& sum : sums)
  {
    const double length = std::sqrt(dot(sum, sum));
    for (double s : sum)
    {
      normals.push_back(length > 0.0 ? static_cast<float>(s * (1.0 / length)) : 0.0f);
    }
  }
  return normals;
}

Vector faceNormal(vtkPolyData* mesh, const Face& face)
{
  const Vector origin = pointOf(mesh, face[0]);
  Vector area{ 0.0, 0.0, 0.0 };
  for (std::size_t i = 1; i + 1 < face.size(); ++i)
  {
    const Vector term = cross(pointOf(mesh, face[i]) - origin, pointOf(mesh, face[i + 1]) - origin);
    area = { area[0] + term[0], area[1] + term[1], area[2] + term[2] };
  }
  return dot(area, area) > 0.0 ? unit(area) : Vector{ 0.0, 0.0, 0.0 };
}

vtkSmartPointer<vtkIntArray> makeNumbers(const char* name, vtkIdType count)
{
  auto numbers = vtkSmartPointer<vtkIntArray>::New();
  numbers->SetName(name);
  numbers->SetNumberOfValues(count);
  std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + count, 0);
  return numbers;
}

std::vector<float> valuesOf(vtkDataArray* array)
{
  std::vector<float> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      values.push_back(static_cast<float>(array->GetComponent(i, k)));
    }
  }
  return values;
}

Vector tupleOf(vtkDataArray* array, vtkIdType i)
{
  Vector v;
  array->GetTuple(i, v.data());
  return v;
}

void expectNear(const Vector& value, const Vector& expected, double tolerance)
{
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(value[k], expected[k], tolerance) << "component " << k;
  }
}

class Messages::Listener : public vtkCommand
{
public:
  static Listener* New() { return new Listener; }

  void Execute(vtkObject*, unsigned long event, void* data) override
  {
    if (this->Owner)
    {
      auto& list = event == vtkCommand::ErrorEvent ? this->Owner->errors : this->Owner->warnings;
      list.emplace_back(static_cast<const char*>(data));
    }
  }

  Messages* Owner = nullptr;
};

Messages::Messages(vtkAlgorithm* algorithm)
{
  vtkNew<Listener> listener;
  listener->Owner = this;
  algorithm->AddObserver(vtkCommand::ErrorEvent, listener);
  algorithm->AddObserver(vtkCommand::WarningEvent, listener);
  // The executive adds that the algorithm failed, which is not new information.
  vtkNew<Listener> deaf;
  algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, deaf);
}
