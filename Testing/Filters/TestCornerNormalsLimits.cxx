// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How many normals a mesh gets, how many it may have, and how long computing them may take.

#include "TestingCorners.h"

#include "CellBlocks.h"
#include "CornerNormals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{
// A mesh's arrays as faces.
struct MeshArrays
{
  std::vector<double> points;
  std::vector<std::int64_t> offsets = std::vector<std::int64_t>(1, 0), corners;
  lambent::Faces faces;

  explicit MeshArrays(const PolygonMesh& mesh)
  {
    for (const Vec3& p : mesh.points)
    {
      this->points.insert(this->points.end(), { p.x, p.y, p.z });
    }
    for (const auto& face : mesh.faces)
    {
      this->corners.insert(this->corners.end(), face.begin(), face.end());
      this->offsets.push_back(static_cast<std::int64_t>(this->corners.size()));
    }
    this->faces.points = { this->points.data(), true, mesh.points.size() };
    this->faces.cells = { { this->offsets.data(), true, this->offsets.size() },
      { this->corners.data(), true, this->corners.size() } };
    this->faces.blocks =
      checkCells(this->faces.cells, mesh.points.size(), lambent::Parallel()).blocks;
  }
};

// Remembers the progress of the work.
class WatchedWork : public lambent::Parallel
{
public:
  void checkpoint(double done) const override { this->Done = done; }
  mutable double Done = 0.0;
};
}

TEST(CornerNormals, SmoothMeshesNeedNoNumbers)
{
  const PolygonMesh sheet = makeSheet(20, [](double x, double y) { return 0.2 * x * y; });
  const MeshArrays arrays(sheet);
  const lambent::Faces& faces = arrays.faces;
  const auto normals = lambent::computeCornerNormals(faces, 30.0, lambent::Parallel());
  EXPECT_FALSE(normals.numbers);
  EXPECT_EQ(normals.count, sheet.points.size());
  std::vector<float> ofPoints(3 * sheet.points.size());
  lambent::computePointNormals(
    faces, lambent::Weighting::Angle, 1.0f, lambent::Parallel(), ofPoints.data());
  EXPECT_EQ(
    std::vector<float>(normals.normals.get(), normals.normals.get() + ofPoints.size()), ofPoints);
}

// The number of normals is limited because corners have 32-bit indices of normals.
TEST(CornerNormals, TooManyAreAnError)
{
  const MeshArrays cube(makeCubeOfQuads());
  EXPECT_EQ(lambent::computeCornerNormals(cube.faces, 30.0, lambent::Parallel(), 24).count, 24u);
  for (const std::size_t most : { 23, 8, 7 })
  {
    try
    {
      lambent::computeCornerNormals(cube.faces, 30.0, lambent::Parallel(), most);
      FAIL() << "no error";
    }
    catch (const std::runtime_error& error)
    {
      EXPECT_EQ(std::string(error.what()),
        "there would be more than " + std::to_string(most) +
          " normals. Compute them with vtkLambentNormals, or render the mesh in parts.");
    }
  }
  // If no corner needs an index, there may be more points.
  EXPECT_FALSE(lambent::computeCornerNormals(cube.faces, 180.0, lambent::Parallel(), 7).numbers);
}

TEST(CornerNormals, TooManyAreDetectedEarly)
{
  PolygonMesh cubes;
  for (int k = 0; k < 200000; ++k)
  {
    for (auto face : makeCubeOfQuads().faces)
    {
      std::for_each(face.begin(), face.end(), [k](std::int64_t& point) { point += 8 * k; });
      cubes.faces.push_back(face);
    }
    const auto points = makeCubeOfQuads().points;
    cubes.points.insert(cubes.points.end(), points.begin(), points.end());
  }
  const MeshArrays arrays(cubes);
  const WatchedWork work;
  EXPECT_THROW(lambent::computeCornerNormals(arrays.faces, 30.0, work, cubes.points.size() + 1),
    std::runtime_error);
  EXPECT_LT(work.Done, 0.5);
}

// Two faces with many corners meet at all of them, several times at each. Comparing the faces again
// at each corner, or at each rotation, took minutes.
TEST(CornerNormals, PeriodicPolygonsTakeLittleTime)
{
  constexpr int period = 1250, repeats = 16;
  PolygonMesh mesh;
  std::vector<std::int64_t> ring;
  for (int i = 0; i < period; ++i)
  {
    const double turn = 6.283185307179586 * i / period;
    mesh.points.emplace_back(std::cos(turn), std::sin(turn), 0.1 * std::cos(9.0 * turn));
  }
  mesh.points.insert(mesh.points.end(), 2, Vec3(1.0, 0.0, 0.0));
  for (int k = 0; k < period * repeats; ++k)
  {
    ring.push_back(k % period);
  }
  for (const std::int64_t last : { period, period + 1 }) // opposite the first time only
  {
    std::vector<std::int64_t> front = ring, back = ring;
    front.push_back(period);
    back.push_back(last);
    mesh.faces = { front, { back.rbegin(), back.rend() } };
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<float> normals =
      computedCornerNormals(mesh, 180.0, MeshStorage::Wide, lambent::Parallel());
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(seconds.count(), 2.0); // takes about 0.02 on current machines
    for (std::size_t corner = 0; corner < front.size(); ++corner)
    {
      EXPECT_GT(normals[3 * corner + 2], 0.5);
      EXPECT_LT(normals[3 * (front.size() + corner) + 2], -0.5);
    }
  }
}
