// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Cells of the types 21 to 36 and 60 to 81 in VTK's files: their surface has the area of the shape,
// and as many polygons as there are between the nodes.

#include "BrokenFiles.h"

#include "LinearCells.h"
#include "Messages.h"
#include "Progress.h"
#include "ReadSurface.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkHigherOrderQuadrilateral.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace lambent::command;

namespace
{

/// A cell of some type, and the expected result.
struct Case
{
  int type;
  vtkIdType nodes;
  vtkIdType polygons;
  double area;
  int linear = VTK_EMPTY_CELL; ///< the type whose corners are used if VTK has no nodes for `type`
};

const double Root2 = std::sqrt(2.0);
const double Hexagon = 1.5 * std::sqrt(3.0);
const double Tetrahedron = 1.5 + 0.5 * std::sqrt(3.0);
const double Wedge = 3.0 + Root2;
const double Pyramid = 2.0 + Root2; // its apex is above a corner, as in VTK's parameters

// Cells with nodes between their corners: VTK triangulates types up to 37, and types from 68 on are
// divided along their nodes.
const Case Cases[] = {
  { VTK_QUADRATIC_EDGE, 3, 0, 0.0 },
  { VTK_QUADRATIC_TRIANGLE, 6, 4, 0.5 },
  { VTK_QUADRATIC_QUAD, 8, 6, 1.0 },
  { VTK_QUADRATIC_TETRA, 10, 16, Tetrahedron },
  { VTK_QUADRATIC_HEXAHEDRON, 20, 36, 6.0 },
  { VTK_QUADRATIC_WEDGE, 15, 26, Wedge },
  { VTK_QUADRATIC_PYRAMID, 13, 22, Pyramid },
  { VTK_BIQUADRATIC_QUAD, 9, 8, 1.0 },
  { VTK_TRIQUADRATIC_HEXAHEDRON, 27, 48, 6.0 },
  { VTK_QUADRATIC_LINEAR_QUAD, 6, 4, 1.0 },
  { VTK_QUADRATIC_LINEAR_WEDGE, 12, 20, Wedge },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 18, 32, Wedge },
  { VTK_BIQUADRATIC_QUADRATIC_HEXAHEDRON, 24, 44, 6.0 },
  { VTK_BIQUADRATIC_TRIANGLE, 7, 6, 0.5 },
  { VTK_CUBIC_LINE, 4, 0, 0.0 },
  { VTK_HIGHER_ORDER_EDGE, 3, 0, 0.0, VTK_LINE },
  { VTK_HIGHER_ORDER_TRIANGLE, 6, 1, 0.5, VTK_TRIANGLE },
  { VTK_HIGHER_ORDER_QUAD, 9, 1, 1.0, VTK_QUAD },
  { VTK_HIGHER_ORDER_TETRAHEDRON, 10, 4, Tetrahedron, VTK_TETRA },
  { VTK_HIGHER_ORDER_WEDGE, 18, 5, Wedge, VTK_WEDGE },
  { VTK_HIGHER_ORDER_PYRAMID, 14, 5, Pyramid, VTK_PYRAMID },
  { VTK_HIGHER_ORDER_HEXAHEDRON, 27, 6, 6.0, VTK_HEXAHEDRON },
  { VTK_LAGRANGE_CURVE, 3, 0, 0.0 },
  { VTK_LAGRANGE_TRIANGLE, 3, 1, 0.5 },
  { VTK_LAGRANGE_TRIANGLE, 6, 4, 0.5 },
  { VTK_LAGRANGE_TRIANGLE, 15, 16, 0.5 },
  { VTK_LAGRANGE_QUADRILATERAL, 4, 1, 1.0 },
  { VTK_LAGRANGE_QUADRILATERAL, 9, 4, 1.0 },
  { VTK_LAGRANGE_QUADRILATERAL, 16, 9, 1.0 },
  { VTK_LAGRANGE_TETRAHEDRON, 4, 4, Tetrahedron },
  { VTK_LAGRANGE_TETRAHEDRON, 10, 16, Tetrahedron },
  { VTK_LAGRANGE_TETRAHEDRON, 20, 36, Tetrahedron },
  { VTK_LAGRANGE_TETRAHEDRON, 35, 64, Tetrahedron },
  { VTK_LAGRANGE_HEXAHEDRON, 8, 6, 6.0 },
  { VTK_LAGRANGE_HEXAHEDRON, 27, 24, 6.0 },
  { VTK_LAGRANGE_HEXAHEDRON, 64, 54, 6.0 },
  { VTK_LAGRANGE_WEDGE, 6, 5, Wedge },
  { VTK_LAGRANGE_WEDGE, 18, 20, Wedge },
  { VTK_LAGRANGE_WEDGE, 40, 45, Wedge },
  { VTK_LAGRANGE_WEDGE, 21, 5, Wedge, VTK_WEDGE },
  { VTK_LAGRANGE_PYRAMID, 14, 5, Pyramid, VTK_PYRAMID },
  { VTK_BEZIER_CURVE, 3, 0, 0.0 },
  { VTK_BEZIER_TRIANGLE, 6, 1, 0.5, VTK_TRIANGLE },
  { VTK_BEZIER_QUADRILATERAL, 9, 1, 1.0, VTK_QUAD },
  { VTK_BEZIER_TETRAHEDRON, 10, 4, Tetrahedron, VTK_TETRA },
  { VTK_BEZIER_HEXAHEDRON, 27, 6, 6.0, VTK_HEXAHEDRON },
  { VTK_BEZIER_WEDGE, 18, 5, Wedge, VTK_WEDGE },
  { VTK_BEZIER_PYRAMID, 14, 5, Pyramid, VTK_PYRAMID },
};

vtkSmartPointer<vtkUnstructuredGrid> OneCell(int type, vtkPoints* points)
{
  std::vector<vtkIdType> ids(static_cast<std::size_t>(points->GetNumberOfPoints()));
  std::iota(ids.begin(), ids.end(), 0);
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(points);
  grid->Allocate(1);
  grid->InsertNextCell(type, points->GetNumberOfPoints(), ids.data());
  return grid;
}

/// The nodes of VTK's class for the type. If it has none: the corners, with all other nodes far
/// away.
vtkSmartPointer<vtkPoints> Nodes(const Case& one)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetNumberOfPoints(one.nodes);
  for (vtkIdType k = 0; k < one.nodes; ++k)
  {
    points->SetPoint(k, 100.0 + k, 50.0 * k, -30.0 * k);
  }
  const bool hasCorners = one.linear != VTK_EMPTY_CELL;
  const auto linear = vtkSmartPointer<vtkCell>::Take(
    hasCorners ? vtkGenericCell::InstantiateCell(one.linear) : nullptr);
  const auto grid = OneCell(one.type, points);
  vtkCell* const cell = linear ? linear.Get() : grid->GetCell(0);
  const double* const nodes = cell->GetParametricCoords();
  const vtkIdType known = linear ? linear->GetNumberOfPoints() : one.nodes;
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->DeepCopy(points);
  for (vtkIdType k = 0; k < known; ++k)
  {
    result->SetPoint(k, nodes + 3 * k);
  }
  for (int k = 0; one.type == VTK_QUADRATIC_PYRAMID && k < 4; ++k)
  {
    const double* const corner = nodes + 3 * k; // the parameters do not narrow towards the apex
    result->SetPoint(9 + k, 0.5 * corner[0], 0.5 * corner[1], 0.5);
  }
  return result;
}

double AreaOf(vtkPolyData* mesh)
{
  double area = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetPolys()->GetNumberOfCells(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    double normal[3];
    area +=
      vtkPolygon::ComputeArea(mesh->GetPoints(), ids->GetNumberOfIds(), ids->GetPointer(0), normal);
  }
  return area;
}

vtkSmartPointer<vtkPolyData> ReadBack(const Scratch& scratch)
{
  VtkMessages messages(true);
  Progress progress(false);
  auto mesh = ReadSurface(scratch.path, messages, progress);
  testing::internal::CaptureStderr();
  messages.FlushWarnings("");
  EXPECT_EQ(testing::internal::GetCapturedStderr().find("incomplete"), std::string::npos);
  return mesh;
}

/// Writes the grid to a file of each kind and reads it.
template <typename Expect>
void ForEachFile(vtkUnstructuredGrid* grid, const Expect& expect)
{
  const Scratch xml(".vtu");
  vtkNew<vtkXMLUnstructuredGridWriter> xmlWriter;
  xmlWriter->SetInputData(grid);
  xmlWriter->SetFileName(xml.path.c_str());
  ASSERT_EQ(xmlWriter->Write(), 1);
  expect(ReadBack(xml));
  for (const int type : { VTK_ASCII, VTK_BINARY })
  {
    const Scratch legacy(".vtk");
    vtkNew<vtkUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    writer->SetFileType(type);
    writer->SetFileVersion(vtkUnstructuredGridWriter::VTK_LEGACY_READER_VERSION_5_1);
    writer->SetFileName(legacy.path.c_str());
    ASSERT_EQ(writer->Write(), 1);
    expect(ReadBack(legacy));
  }
}

} // namespace

TEST(CellTypes, HaveTheAreaOfTheirShape)
{
  for (const Case& one : Cases)
  {
    if (one.polygons == 0)
    {
      continue;
    }
    SCOPED_TRACE("type " + std::to_string(one.type) + ", nodes " + std::to_string(one.nodes));
    ForEachFile(OneCell(one.type, Nodes(one)),
      [&one](vtkPolyData* mesh)
      {
        EXPECT_EQ(mesh->GetNumberOfPolys(), one.polygons);
        EXPECT_NEAR(AreaOf(mesh), one.area, 1e-5);
      });
  }
}

// Lines are not a surface, and the other cells of the file are still drawn.
TEST(CellTypes, LinesAndATriangle)
{
  for (const Case& one : Cases)
  {
    if (one.polygons > 0)
    {
      continue;
    }
    SCOPED_TRACE(one.type);
    const auto grid = OneCell(one.type, Nodes(one));
    const vtkIdType ids[] = { 0, 1, 2 };
    grid->InsertNextCell(VTK_TRIANGLE, 3, ids);
    ForEachFile(grid, [](vtkPolyData* mesh) { EXPECT_EQ(mesh->GetNumberOfPolys(), 1); });
  }
}

// The corners, then a node between each corner and the next.
TEST(CellTypes, PolygonsWithNodesBetweenTheirCorners)
{
  vtkNew<vtkPoints> points;
  for (int k = 0; k < 12; ++k)
  {
    const double angle = std::acos(-1.0) / 3.0 * (k % 6 + (k < 6 ? 0.0 : 0.5));
    const double radius = k < 6 ? 1.0 : 0.5 * std::sqrt(3.0);
    points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), 0.0);
  }
  for (const int type : { VTK_QUADRATIC_POLYGON, VTK_HIGHER_ORDER_POLYGON })
  {
    SCOPED_TRACE(type);
    ForEachFile(
      OneCell(type, points), [](vtkPolyData* mesh) { EXPECT_NEAR(AreaOf(mesh), Hexagon, 1e-5); });
  }
}

// A node outside the corners' plane changes the surface: it has more than the corners.
TEST(CellTypes, SurfacesFollowTheNodes)
{
  auto points = Nodes({ VTK_LAGRANGE_QUADRILATERAL, 9, 4, 1.0 });
  points->SetPoint(8, 0.5, 0.5, 0.5);
  ForEachFile(OneCell(VTK_LAGRANGE_QUADRILATERAL, points),
    [](vtkPolyData* mesh)
    {
      double bounds[6];
      mesh->GetBounds(bounds);
      EXPECT_EQ(bounds[5], 0.5);
    });
}

// An array of the cells declares 2 steps in one direction and 3 in the other.
TEST(CellTypes, OrdersThatDifferByDirection)
{
  constexpr int orders[] = { 2, 3, 1 };
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(12);
  for (int j = 0; j <= 3; ++j)
  {
    for (int i = 0; i <= 2; ++i)
    {
      points->SetPoint(
        vtkHigherOrderQuadrilateral::PointIndexFromIJK(i, j, orders), i / 2.0, j / 3.0, 0.0);
    }
  }
  const auto grid = OneCell(VTK_LAGRANGE_QUADRILATERAL, points);
  vtkNew<vtkDoubleArray> degrees;
  degrees->SetName("HigherOrderDegrees");
  degrees->SetNumberOfComponents(3);
  degrees->InsertNextTuple3(2, 3, 0);
  grid->GetCellData()->AddArray(degrees); // VTK 9.1 does not write it to .vtk files as an attribute
  ForEachFile(grid,
    [](vtkPolyData* mesh)
    {
      EXPECT_EQ(mesh->GetNumberOfPolys(), 6);
      EXPECT_NEAR(AreaOf(mesh), 1.0, 1e-5);
    });
}

// There is no wall between two cells, and each polygon has the data of its cell.
TEST(CellTypes, NeighboursShareTheirNodes)
{
  const auto points = Nodes({ VTK_LAGRANGE_TETRAHEDRON, 10, 16, Tetrahedron });
  const auto grid = OneCell(VTK_LAGRANGE_TETRAHEDRON, points);
  points->InsertNextPoint(1.0, 1.0, 1.0); // opposite to the face of the corners 1, 2, 3
  const vtkIdType apex = 10;
  for (const double* const corner : { points->GetPoint(1), points->GetPoint(2) })
  {
    const double middle[] = { 0.5 * (corner[0] + 1), 0.5 * (corner[1] + 1), 0.5 * (corner[2] + 1) };
    points->InsertNextPoint(middle);
  }
  points->InsertNextPoint(0.5, 0.5, 1.0);
  // The corners come first, then the nodes between 0-1, 1-2, 2-0, 0-3, 1-3 and 2-3.
  const vtkIdType ids[] = { 1, 2, 3, apex, 5, 9, 8, 11, 12, 13 };
  grid->InsertNextCell(VTK_LAGRANGE_TETRAHEDRON, 10, ids);
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  values->InsertNextValue(1.0);
  values->InsertNextValue(2.0);
  grid->GetCellData()->AddArray(values);
  ForEachFile(grid,
    [](vtkPolyData* mesh)
    {
      ASSERT_EQ(mesh->GetNumberOfPolys(), 24);
      vtkDataArray* const value = mesh->GetCellData()->GetArray("value");
      double sum = 0.0;
      for (vtkIdType cell = 0; cell < 24; ++cell)
      {
        sum += value->GetComponent(cell, 0);
      }
      EXPECT_EQ(sum, 12 * 1.0 + 12 * 2.0);
    });
}

// Polyhedra in the same grid keep their faces.
TEST(CellTypes, PolyhedraInTheSameGrid)
{
  const auto grid = OneCell(VTK_LAGRANGE_TRIANGLE, Nodes({ VTK_LAGRANGE_TRIANGLE, 6, 4, 0.5 }));
  grid->GetPoints()->InsertNextPoint(0.2, 0.2, 1.0);
  vtkNew<vtkIdList> faces;
  for (const vtkIdType id : { 4, 3, 0, 1, 2, 3, 0, 6, 1, 3, 1, 6, 2, 3, 2, 6, 0 })
  {
    faces->InsertNextId(id);
  }
  grid->InsertNextCell(VTK_POLYHEDRON, faces);
  ForEachFile(grid, [](vtkPolyData* mesh) { EXPECT_EQ(mesh->GetNumberOfPolys(), 8); });
}

// An array too short for the cells is an error, and is not read beyond its end.
TEST(CellTypes, DataThatIsTooShort)
{
  const auto grid = OneCell(VTK_LAGRANGE_TRIANGLE, Nodes({ VTK_LAGRANGE_TRIANGLE, 6, 4, 0.5 }));
  vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  grid->GetCellData()->AddArray(values);
  VtkMessages messages(true);
  EXPECT_EQ(WithLinearCells(grid), grid);
  EXPECT_NE(messages.TakeError(), "");
}

// Cells of other types are not changed.
TEST(CellTypes, GridsOfOtherTypesAreNotCopied)
{
  const auto grid = OneCell(VTK_QUADRATIC_TETRA, Nodes({ VTK_QUADRATIC_TETRA, 10, 16, 0.0 }));
  EXPECT_EQ(WithLinearCells(grid), grid);
}
