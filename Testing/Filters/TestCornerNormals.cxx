// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The ray tracer's computed normals: the bits of their definition, and known results on special
// meshes.

#include "TestingCorners.h"

#include "../Core/InstructionSets.h"
#include "../Core/ThreadedParallel.h"

#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <string>

namespace
{
void expectDefinition(const PolygonMesh& exact, const std::vector<double>& angles)
{
  for (const MeshStorage storage : { MeshStorage::Narrow, MeshStorage::Wide })
  {
    const PolygonMesh mesh = storage == MeshStorage::Narrow ? toFloats(exact) : exact;
    for (const double angle : angles)
    {
      SCOPED_TRACE("feature angle " + std::to_string(angle));
      const std::vector<float> expected = referenceCornerNormals(mesh, angle);
      onAllTargets(
        [&]()
        {
          for (const int workers : { 1, 3 })
          {
            EXPECT_EQ(
              computedCornerNormals(mesh, angle, storage, ThreadedParallel(workers)), expected);
          }
        });
    }
  }
}

std::vector<float> computed(const PolygonMesh& mesh, double angle)
{
  return computedCornerNormals(mesh, angle, MeshStorage::Wide, ThreadedParallel(2));
}

const std::vector<double> someAngles = { 0.0, 20.0, 30.0, 75.0, 150.0, 180.0 };
}

TEST(CornerNormals, EqualDefinitionOnRandomPolygons)
{
  for (unsigned int seed = 1; seed <= 16; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectDefinition(makeRandomPolygons(seed), someAngles);
  }
}

TEST(CornerNormals, EqualDefinitionOnClosedMeshes)
{
  for (unsigned int seed = 1; seed <= 3; ++seed)
  {
    for (const double dent : { 0.0, 0.02, 0.2 })
    {
      SCOPED_TRACE("dents of " + std::to_string(dent));
      expectDefinition(makeDentedBall(seed, dent), { 10.0, 30.0, 60.0, 180.0 });
    }
  }
  expectDefinition(makeCubeOfQuads(), { 30.0, 89.0, 91.0, 180.0 });
}

TEST(CornerNormals, EqualDefinitionOnDoubledAndMirroredMeshes)
{
  const PolygonMesh ball = makeDentedBall(7, 0.1);
  const PolygonMesh sheet = makeSheet(6, [](double x, double y) { return x * x * y; });
  for (const PolygonMesh& mesh : { ball.doubled(), ball.mirrored(), ball.mirrored().doubled(),
         sheet.doubled(), sheet.doubled().doubled(), sheet.mirrored() })
  {
    expectDefinition(mesh, { 30.0, 90.0, 180.0 });
  }
}

// Polygons of many corners. Some points are named several times in a row, also across the start.
TEST(CornerNormals, EqualDefinitionOnLargePolygons)
{
  PolygonMesh prism;
  constexpr std::int64_t sides = 40;
  for (std::int64_t side = 0; side < sides; ++side)
  {
    const double turn = 6.283185307179586 * side / sides, radius = side % 5 == 0 ? 0.6 : 1.0;
    prism.points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), 0.1 * (side % 3));
    prism.points.emplace_back(radius * std::cos(turn), radius * std::sin(turn), 2.0);
  }
  std::vector<std::int64_t> top{ 1 }, bottom, three;
  for (std::int64_t side = 0; side < sides; ++side)
  {
    const std::int64_t p = 2 * side, q = 2 * ((side + 1) % sides);
    prism.faces.push_back({ p, q, q + 1, p + 1 });
    top.insert(top.end(), side % 7 == 0 ? 3 : 1, p + 1);
    bottom.insert(bottom.begin(), side % 4 == 0 ? 2 : 1, p);
    three.push_back(side < 10 ? 0 : side < 25 ? 3 : 8);
  }
  top.push_back(1);
  top.insert(top.begin() + 30, 1); // the same point at another corner
  prism.faces.insert(prism.faces.end(), { top, bottom, three });
  expectDefinition(prism, { 5.0, 30.0, 80.0, 95.0, 180.0 });
}

// Rings of ids that are periodic or nearly so, compared with all their rotations.
TEST(CornerNormals, EqualDefinitionOnPeriodicPolygons)
{
  for (const int period : { 1, 3, 5, 7 })
  {
    for (const int repeats : { 3, 6, 9 })
    {
      PolygonMesh mesh;
      std::vector<std::int64_t> ring;
      for (int i = 0; i < 2 * period + 4; ++i)
      {
        mesh.points.emplace_back(std::cos(0.4 * i), std::sin(0.4 * i), 0.05 * (i % 4));
      }
      for (int k = 0; k < period * repeats; ++k)
      {
        ring.push_back(k % period);
      }
      for (const std::int64_t apex : { period, period + 1 }) // two faces that differ in one point
      {
        auto face = ring;
        face.insert(face.end(), { apex, period + 2, 0, 1 % period });
        mesh.faces.push_back(face);
        std::rotate(face.begin(), face.begin() + period + 1, face.end());
        mesh.faces.emplace_back(face.rbegin(), face.rend());
      }
      SCOPED_TRACE(std::to_string(repeats) + " times " + std::to_string(period));
      expectDefinition(mesh, { 30.0, 180.0 });
    }
  }
}

// Pages of a book: one edge, the spine, belongs to many faces.
TEST(CornerNormals, EqualDefinitionOnEdgesOfManyFaces)
{
  for (const int pages : { 3, 4, 63, 64, 65, 66 })
  {
    SCOPED_TRACE(std::to_string(pages) + " pages");
    PolygonMesh book;
    book.points = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } };
    for (int page = 0; page < pages; ++page)
    {
      const double x = -1.0 + 2.0 * page / (pages - 1);
      const auto outer = static_cast<std::int64_t>(book.points.size());
      book.points.insert(book.points.end(), { { x, 1.0, 0.0 }, { x, 1.0, 1.0 } });
      page % 2 ? book.faces.push_back({ 0, outer, outer + 1, 1 })
               : book.faces.push_back({ 0, 1, outer + 1, outer });
    }
    expectDefinition(book, { 1.0, 30.0, 179.0, 180.0 });
  }
}

TEST(CornerNormals, FacesOfACubeStayFlat)
{
  const PolygonMesh cube = makeCubeOfQuads();
  const std::vector<float> sharp = computed(cube, 89.0);
  const std::vector<float> smooth = computed(cube, 91.0);
  for (std::size_t face = 0; face < 6; ++face)
  {
    const Vec3 normal = lambent::faceNormal(cube.points, cube.faces[face].data(), 4);
    for (std::size_t k = 0; k < 4; ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        const std::size_t i = 3 * (4 * face + k) + axis;
        EXPECT_EQ(sharp[i], static_cast<float>(normal[axis]));
        const double outward = cube.points[cube.faces[face][k]][axis] > 0.5 ? 1.0 : -1.0;
        EXPECT_NEAR(smooth[i], outward / std::sqrt(3.0), 1e-7);
      }
    }
  }
}

// The two sides stay apart even at 180 degrees, where everything else is smooth.
TEST(CornerNormals, FacesOnBothSidesOfASheetDoNotMix)
{
  const PolygonMesh sheet = makeSheet(8, [](double x, double y) { return 0.3 * x * y + x * x; });
  for (const double angle : { 30.0, 60.0, 180.0 })
  {
    const std::vector<float> one = computed(sheet, angle);
    const std::vector<float> two = computed(sheet.doubled(), angle);
    ASSERT_EQ(two.size(), 2 * one.size());
    for (std::size_t face = 0; face < sheet.faces.size(); ++face)
    {
      for (std::size_t k = 0; k < 4; ++k)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          const float front = one[3 * (4 * face + k) + axis];
          EXPECT_EQ(two[3 * (4 * face + k) + axis], front);
          EXPECT_NEAR(two[one.size() + 3 * (4 * face + 3 - k) + axis], -front, 1e-7);
        }
      }
    }
  }
}

// Neighbours of opposite orientation each have the normal of their own side, not rounding noise.
TEST(CornerNormals, FacesOfOppositeOrientationDoNotCancel)
{
  PolygonMesh sheet = makeSheet(7, [](double x, double y) { return 0.1 * x - 0.2 * y; });
  for (std::size_t face = 0; face < sheet.faces.size(); face += 2)
  {
    std::reverse(sheet.faces[face].begin(), sheet.faces[face].end());
  }
  const Vec3 up = lambent::normalized({ -0.1, 0.2, 1.0 });
  for (const double angle : { 30.0, 180.0 })
  {
    const std::vector<float> normals = computed(sheet, angle);
    for (std::size_t corner = 0; corner < normals.size() / 3; ++corner)
    {
      const double side = corner / 4 % 2 == 0 ? -1.0 : 1.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        EXPECT_NEAR(normals[3 * corner + axis], side * up[axis], 1e-6);
      }
    }
  }
}

// The faces around the tip of a needle face all directions, so their sum is only rounding error.
TEST(CornerNormals, FacesOfANeedleHaveTheirOwnNormals)
{
  constexpr int sides = 48;
  PolygonMesh needle;
  needle.points.emplace_back(0.0, 0.0, 1e9);
  for (int side = 0; side < sides; ++side)
  {
    const double turn = 6.283185307179586 * side / sides;
    needle.points.emplace_back(std::cos(turn), std::sin(turn), 0.0);
    needle.faces.push_back({ 0, 1 + side, 1 + (side + 1) % sides });
  }
  const std::vector<float> normals = computed(needle, 30.0);
  for (std::size_t face = 0; face < needle.faces.size(); ++face)
  {
    const Vec3 own = lambent::faceNormal(needle.points, needle.faces[face].data(), 3);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(normals[9 * face + axis], static_cast<float>(own[axis])) << "face " << face;
    }
  }
}

// The sides meet at 30 degrees, up to the rounding of floats.
TEST(CornerNormals, TwelveSidedTubeIsSmooth)
{
  for (int start = 0; start < 40; ++start)
  {
    PolygonMesh tube;
    for (int side = 0; side < 12; ++side)
    {
      const double turn = 0.01 * start + 6.283185307179586 * side / 12;
      tube.points.emplace_back(std::cos(turn), std::sin(turn), 0.0);
      tube.points.emplace_back(std::cos(turn), std::sin(turn), 1.0);
      const std::int64_t p = 2 * side, q = 2 * ((side + 1) % 12);
      tube.faces.push_back({ p, q, q + 1, p + 1 });
    }
    const std::vector<float> normals =
      computedCornerNormals(toFloats(tube), 30.0, MeshStorage::Narrow, lambent::Parallel());
    for (std::size_t i = 0; i < normals.size(); ++i)
    {
      const Vec3& point = tube.points[tube.faces[i / 12][i / 3 % 4]];
      EXPECT_NEAR(normals[i], i % 3 == 2 ? 0.0 : point[static_cast<int>(i % 3)], 1e-6) << start;
    }
  }
}

// vtkPolyDataNormals gives each group of linked corners its own copy of the point.
TEST(CornerNormals, GroupsEqualVTKsOnClosedMeshes)
{
  for (const double angle : { 20.0, 30.0, 45.0 })
  {
    const PolygonMesh mesh = toFloats(makeDentedBall(3, 0.15));
    vtkNew<vtkPoints> points;
    for (const Vec3& p : mesh.points)
    {
      points->InsertNextPoint(p.x, p.y, p.z);
    }
    vtkNew<vtkCellArray> cells;
    for (const auto& face : mesh.faces)
    {
      cells->InsertNextCell({ face[0], face[1], face[2] });
    }
    vtkNew<vtkPolyData> polyData;
    polyData->SetPoints(points);
    polyData->SetPolys(cells);
    vtkNew<vtkPolyDataNormals> filter;
    filter->SetInputData(polyData);
    filter->SetFeatureAngle(angle);
    filter->ConsistencyOff();
    filter->Update();

    const std::vector<float> normals = computed(mesh, angle);
    std::map<std::int64_t, std::set<std::vector<float>>> ofPoint;
    std::map<vtkIdType, std::set<std::vector<float>>> ofCopy;
    std::map<std::int64_t, std::set<vtkIdType>> copiesOf;
    vtkNew<vtkIdList> ids;
    for (std::size_t face = 0; face < mesh.faces.size(); ++face)
    {
      filter->GetOutput()->GetPolys()->GetCellAtId(static_cast<vtkIdType>(face), ids);
      for (vtkIdType k = 0; k < 3; ++k)
      {
        const float* n = &normals[9 * face + 3 * k];
        ofPoint[mesh.faces[face][k]].insert({ n[0], n[1], n[2] });
        ofCopy[ids->GetId(k)].insert({ n[0], n[1], n[2] });
        copiesOf[mesh.faces[face][k]].insert(ids->GetId(k));
      }
    }
    int split = 0;
    for (const auto& [point, copies] : copiesOf)
    {
      EXPECT_EQ(ofPoint[point].size(), copies.size()) << "point " << point;
      split += copies.size() > 1;
    }
    for (const auto& [copy, all] : ofCopy)
    {
      EXPECT_EQ(all.size(), 1u) << "copy " << copy;
    }
    EXPECT_GT(split, 20);
  }
}
