// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Messages.h"
#include "NumberedMesh.h"
#include "Progress.h"
#include "SurfaceOf.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

using namespace lambent::command;

namespace
{

using Numbers = std::vector<std::int64_t>;

/// The corners of a unit cube have the numbers 100 x + 10 y + z; the tip of a pyramid has the
/// number
/// 7. Simulations count corners so that the triangle or square of the first ones is clockwise when
/// seen from outside.
void AddCube(NumberedMesh& mesh)
{
  for (int corner = 7; corner >= 0; --corner)
  {
    const int x = corner >> 2, y = corner >> 1 & 1, z = corner & 1;
    const double point[] = { double(x), double(y), double(z) };
    mesh.AddNode(100 * x + 10 * y + z, point);
  }
  const double tip[] = { 0.5, 0.5, 1 };
  mesh.AddNode(7, tip);
}

/// Positive if the polygons are anticlockwise when seen from outside.
double VolumeIn(vtkPolyData* mesh)
{
  double volume = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetPolys()->GetNumberOfCells(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    for (vtkIdType k = 2; k < ids->GetNumberOfIds(); ++k)
    {
      double a[3], b[3], c[3];
      mesh->GetPoint(ids->GetId(0), a);
      mesh->GetPoint(ids->GetId(k - 1), b);
      mesh->GetPoint(ids->GetId(k), c);
      volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                  a[2] * (b[0] * c[1] - b[1] * c[0])) /
        6;
    }
  }
  return volume;
}

vtkSmartPointer<vtkPolyData> Surface(NumberedMesh& mesh)
{
  VtkMessages messages(true);
  Progress progress(false);
  return SurfaceOf(mesh.MakeData(), std::nullopt, messages, progress);
}

std::string FailureOf(NumberedMesh& mesh)
{
  try
  {
    mesh.MakeData();
  }
  catch (const Failure& failure)
  {
    return failure.what();
  }
  return {};
}

} // namespace

TEST(NumberedMesh, VolumesFaceOutwards)
{
  const struct
  {
    ElementShape shape;
    Numbers nodes;
    double volume;
    vtkIdType faces;
  } solids[] = {
    { { VTK_TETRA, 4 }, { 0, 100, 10, 1 }, 1.0 / 6, 4 },
    { { VTK_PYRAMID, 5 }, { 0, 100, 110, 10, 7 }, 1.0 / 3, 5 },
    { { VTK_WEDGE, 6 }, { 0, 100, 10, 1, 101, 11 }, 1.0 / 2, 5 },
    { { VTK_HEXAHEDRON, 8 }, { 0, 100, 110, 10, 1, 101, 111, 11, 999, 999 }, 1, 6 },
  };
  for (const auto& [shape, nodes, volume, faces] : solids)
  {
    NumberedMesh mesh(false);
    mesh.AddElement(1, shape, nodes); // comes before its nodes, and has more nodes than are used
    AddCube(mesh);
    const auto surface = Surface(mesh);
    EXPECT_NEAR(VolumeIn(surface), volume, 1e-12) << shape.cellType;
    EXPECT_EQ(surface->GetNumberOfPolys(), faces) << shape.cellType;
  }
}

TEST(NumberedMesh, MissingNodes)
{
  NumberedMesh mesh(false);
  AddCube(mesh);
  mesh.AddElement(12, { VTK_TRIANGLE, 3 }, { 0, 100, 9 });
  EXPECT_EQ(FailureOf(mesh).rfind("its element 12 uses node 9, which does not exist", 0), 0u);
}

TEST(NumberedMesh, NodesWithTheSameNumber)
{
  for (const bool isLast : { false, true })
  {
    NumberedMesh mesh(isLast);
    AddCube(mesh);
    const double moved[] = { 0, 0, -1 };
    mesh.AddNode(0, moved);
    mesh.AddElement(1, { VTK_TETRA, 4 }, { 0, 100, 10, 1 });
    if (isLast)
    {
      EXPECT_NEAR(VolumeIn(Surface(mesh)), 2.0 / 6, 1e-12);
    }
    else
    {
      EXPECT_EQ(FailureOf(mesh).rfind("it has two nodes with the number 0;", 0), 0u);
    }
  }
}

TEST(NumberedMesh, PartsNumberTheirOwnNodes)
{
  NumberedMesh mesh(false);
  AddCube(mesh);
  mesh.AddElement(1, { VTK_TETRA, 4 }, { 0, 100, 10, 1 });
  mesh.EndPart();
  AddCube(mesh);
  mesh.AddElement(1, { VTK_PYRAMID, 5 }, { 0, 100, 110, 10, 7 });
  EXPECT_NEAR(VolumeIn(Surface(mesh)), 1.0 / 6 + 1.0 / 3, 1e-12);
}

TEST(NumberedMesh, PolygonsHaveNoVolume)
{
  NumberedMesh mesh(false);
  AddCube(mesh);
  mesh.AddElement(1, { VTK_TRIANGLE, 3 }, { 111, 7, 0 });
  mesh.AddElement(2, { VTK_QUAD, 4 }, { 0, 100, 110, 10 });
  const auto data = mesh.MakeData();
  auto* const surface = vtkPolyData::SafeDownCast(data);
  ASSERT_NE(surface, nullptr);
  EXPECT_EQ(surface->GetNumberOfPolys(), 2);
  EXPECT_EQ(surface->GetNumberOfPoints(), 6); // the other points are not used
  double first[3];
  surface->GetPoint(0, first);
  EXPECT_EQ(first[0] + first[1] + first[2], 3);
}

TEST(NumberedMesh, NodesWithoutElements)
{
  NumberedMesh mesh(false);
  AddCube(mesh);
  EXPECT_EQ(mesh.MakeData()->GetNumberOfPoints(), 9);
}

TEST(NumberedMesh, CoordinatesMustBeFinite)
{
  NumberedMesh mesh(false);
  const double point[] = { 0, std::numeric_limits<double>::infinity(), 0 };
  EXPECT_THROW(mesh.AddNode(3, point), Failure);
}
