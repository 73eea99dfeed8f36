// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sharp edges in vtkLambentNormals: which points are copied, in which order, and with which data.

#include "TestingNormals.h"
#include "vtkLambentNormals.h"

#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkSphereSource.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace
{
// The definition of splitting, point by point: a table has the faces of each edge, and groups grow
// from face to face.
std::vector<Face> referenceSplit(
  vtkPolyData* mesh, double cosine, std::vector<vtkIdType>& copiedPoints)
{
  std::vector<Face> faces = facesOf(mesh);
  const std::vector<Face> original = faces;
  std::map<std::pair<vtkIdType, vtkIdType>, std::vector<int>> facesOfEdge;
  std::map<vtkIdType, std::set<int>> facesOfPoint;
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
  {
    for (std::size_t i = 0; i < faces[f].size(); ++i)
    {
      const vtkIdType a = faces[f][i], b = faces[f][(i + 1) % faces[f].size()];
      facesOfEdge[std::minmax(a, b)].push_back(f);
      facesOfPoint[a].insert(f);
    }
  }
  std::set<std::pair<int, int>> smoothlyJoined;
  std::set<std::pair<std::pair<vtkIdType, vtkIdType>, int>> smoothEdges;
  for (const auto& [edge, users] : facesOfEdge)
  {
    if (users.size() == 2)
    {
      const Vector a = faceNormal(mesh, original[users[0]]);
      const Vector b = faceNormal(mesh, original[users[1]]);
      if (dot(a, a) > 0.0 && dot(b, b) > 0.0 && dot(a, b) >= cosine)
      {
        smoothEdges.insert({ edge, users[0] });
      }
    }
  }
  for (const auto& [point, around] : facesOfPoint)
  {
    std::set<int> left = around;
    for (bool isFirst = true; !left.empty(); isFirst = false)
    {
      std::vector<int> group{ *left.begin() };
      left.erase(left.begin());
      for (std::size_t k = 0; k < group.size(); ++k)
      {
        const Face& face = original[group[k]];
        for (std::size_t i = 0; i < face.size(); ++i)
        {
          const auto edge = std::minmax(face[i], face[(i + 1) % face.size()]);
          const std::pair<vtkIdType, vtkIdType> key(edge.first, edge.second);
          if (edge.first != point && edge.second != point)
          {
            continue;
          }
          const std::vector<int>& users = facesOfEdge[key];
          if (smoothEdges.count({ key, users[0] }) == 0)
          {
            continue;
          }
          for (int user : users)
          {
            if (left.erase(user) > 0)
            {
              group.push_back(user);
            }
          }
        }
      }
      if (!isFirst)
      {
        const vtkIdType copy =
          mesh->GetNumberOfPoints() + static_cast<vtkIdType>(copiedPoints.size());
        copiedPoints.push_back(point);
        for (int f : group)
        {
          std::replace(faces[f].begin(), faces[f].end(), point, copy);
        }
      }
    }
  }
  return faces;
}
}

TEST(LambentNormalsSplitting, CubeSplitsIntoItsFaces)
{
  vtkSmartPointer<vtkPolyData> cube = makeCube();
  cube->GetPointData()->AddArray(makeNumbers("Number", 8));
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(cube);
  normals->SplittingOn();
  normals->ComputeCellNormalsOn();
  normals->Update();
  vtkPolyData* output = normals->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 24);
  ASSERT_EQ(output->GetNumberOfCells(), 6);
  EXPECT_EQ(cube->GetNumberOfPoints(), 8);

  // The faces 1, 3 and 5 use point 7. The first keeps it; the others get the last two copies, in
  // this order.
  const std::vector<Face> before = facesOf(cube);
  const std::vector<Face> after = facesOf(output);
  const auto idOf7 = [&](int face)
  {
    return after[face]
                [std::find(before[face].begin(), before[face].end(), 7) - before[face].begin()];
  };
  EXPECT_EQ(idOf7(1), 7);
  EXPECT_EQ(idOf7(3), 22);
  EXPECT_EQ(idOf7(5), 23);

  vtkDataArray* numbers = output->GetPointData()->GetArray("Number");
  ASSERT_NE(numbers, nullptr);
  ASSERT_EQ(numbers->GetNumberOfTuples(), 24);
  for (std::size_t f = 0; f < 6; ++f)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      const vtkIdType id = after[f][i];
      EXPECT_EQ(numbers->GetTuple1(id), before[f][i]) << "point data follows";
      EXPECT_EQ(pointOf(output, id), pointOf(cube, before[f][i]));
      expectNear(
        tupleOf(output->GetPointData()->GetNormals(), id), faceNormal(cube, before[f]), 0.0);
    }
    expectNear(tupleOf(output->GetCellData()->GetNormals(), f), faceNormal(cube, before[f]), 0.0);
  }
}

TEST(LambentNormalsSplitting, RightAnglesAreSharpBelow90Degrees)
{
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(makeCube());
  normals->SplittingOn();
  for (const auto& [angle, points] :
    { std::pair{ 0.0, 24 }, { 89.999999, 24 }, { 90.0, 8 }, { 180.0, 8 } })
  {
    normals->SetFeatureAngle(angle);
    normals->Update();
    EXPECT_EQ(normals->GetOutput()->GetNumberOfPoints(), points) << angle;
  }
}

TEST(LambentNormalsSplitting, AgreesWithVTKOnASplitCube)
{
  vtkNew<vtkPolyDataNormals> reference;
  reference->SetInputData(makeCube());
  reference->ConsistencyOff();
  reference->Update();
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(makeCube());
  normals->SplittingOn();
  normals->Update();
  const std::vector<Face> ours = facesOf(normals->GetOutput());
  const std::vector<Face> theirs = facesOf(reference->GetOutput());
  ASSERT_EQ(normals->GetOutput()->GetNumberOfPoints(), reference->GetOutput()->GetNumberOfPoints());
  for (std::size_t f = 0; f < ours.size(); ++f)
  {
    for (std::size_t i = 0; i < ours[f].size(); ++i)
    {
      EXPECT_EQ(
        pointOf(normals->GetOutput(), ours[f][i]), pointOf(reference->GetOutput(), theirs[f][i]));
      expectNear(tupleOf(normals->GetOutput()->GetPointData()->GetNormals(), ours[f][i]),
        tupleOf(reference->GetOutput()->GetPointData()->GetNormals(), theirs[f][i]), 1e-6);
    }
  }
}

TEST(LambentNormalsSplitting, EqualsTheDefinition)
{
  // A coarse sphere with displaced points has edges of all angles. Further triangles between its
  // points make edges of three and more faces.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(30);
  sphere->Update();
  for (int seed = 1; seed <= 6; ++seed)
  {
    std::vector<Vector> points;
    std::vector<Face> faces = facesOf(sphere->GetOutput());
    unsigned int state = seed;
    const auto random = [&state](unsigned int range)
    {
      state = state * 1664525u + 1013904223u;
      return (state >> 8) % range;
    };
    for (vtkIdType i = 0; i < sphere->GetOutput()->GetNumberOfPoints(); ++i)
    {
      points.push_back(pointOf(sphere->GetOutput(), i) * (1.0 + 0.0001 * random(300)));
    }
    const auto anyPoint = [&] { return static_cast<vtkIdType>(random(points.size())); };
    for (int i = 0; i < 200; ++i)
    {
      faces.push_back(Face(faces[random(faces.size())]));
      faces.back()[1] = anyPoint();
    }
    faces.push_back({ 5, 5, 6 }); // no area
    vtkSmartPointer<vtkPolyData> mesh = makeMesh(points, faces);
    std::vector<vtkIdType> copies;
    const std::vector<Face> expected = referenceSplit(mesh, std::sqrt(0.75), copies);
    vtkNew<vtkLambentNormals> normals;
    normals->SetInputData(mesh);
    normals->SplittingOn();
    normals->Update();
    vtkPolyData* output = normals->GetOutput();
    EXPECT_GT(copies.size(), 100u);
    ASSERT_EQ(output->GetNumberOfPoints(),
      mesh->GetNumberOfPoints() + static_cast<vtkIdType>(copies.size()));
    EXPECT_EQ(facesOf(output), expected);
    for (std::size_t i = 0; i < copies.size(); ++i)
    {
      EXPECT_EQ(pointOf(output, mesh->GetNumberOfPoints() + static_cast<vtkIdType>(i)),
        pointOf(mesh, copies[i]));
    }
    EXPECT_EQ(valuesOf(output->GetPointData()->GetNormals()),
      referenceNormals(output, vtkLambentNormals::ANGLE));
  }
}

TEST(LambentNormalsSplitting, GlobalIdsAreNotCopied)
{
  vtkSmartPointer<vtkPolyData> cube = makeCube();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("Ids");
  ids->SetNumberOfValues(8);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + 8, 100);
  cube->GetPointData()->SetGlobalIds(ids);
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(cube);
  normals->Update();
  EXPECT_EQ(normals->GetOutput()->GetPointData()->GetGlobalIds(), ids);
  normals->SplittingOn();
  normals->Update();
  EXPECT_EQ(normals->GetOutput()->GetPointData()->GetGlobalIds(), nullptr);
}
