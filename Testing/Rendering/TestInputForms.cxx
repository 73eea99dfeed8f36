// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The same surface gives the same picture in every form that polydata can have.
#include "Meshes.h"
#include "Messages.h"

#include "vtkIdList.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

namespace
{
Picture pictureOf(vtkPolyData* mesh, int interpolation = VTK_PHONG)
{
  Studio studio(64, 48);
  const Messages messages(studio.tracer);
  studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
  studio.property->SetInterpolation(interpolation);
  studio.tracer->SetInputData(mesh);
  const Picture picture = render(studio.tracer);
  EXPECT_TRUE(messages.errors().empty());
  EXPECT_TRUE(messages.warnings().empty());
  EXPECT_LT(picture.count(Studio::background()), 64 * 48);
  return picture;
}

/// A copy whose points and normals have another type and memory layout.
template <typename Array>
Mesh withArrays(vtkPolyData* mesh)
{
  const auto convert = [](vtkDataArray* from)
  {
    auto to = vtkSmartPointer<Array>::New();
    to->SetNumberOfComponents(3);
    to->SetNumberOfTuples(from->GetNumberOfTuples());
    for (vtkIdType k = 0; k < from->GetNumberOfTuples(); ++k)
    {
      to->SetTuple(k, from->GetTuple(k));
    }
    return to;
  };
  Mesh copy = Mesh::New();
  copy->ShallowCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetData(convert(mesh->GetPoints()->GetData()));
  copy->SetPoints(points);
  copy->GetPointData()->SetNormals(convert(mesh->GetPointData()->GetNormals()));
  return copy;
}

/// An n-gon in the plane z = 0 with these points, counter-clockwise.
Mesh makePolygon(const std::vector<Vec>& points)
{
  std::vector<vtkIdType> ids(points.size());
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    ids[k] = static_cast<vtkIdType>(k);
  }
  return makeMesh(points, { ids });
}

bool isInside(const std::vector<Vec>& polygon, double x, double y)
{
  bool inside = false; // toggled at every edge that a ray to the right crosses
  for (std::size_t k = 0, last = polygon.size() - 1; k < polygon.size(); last = k++)
  {
    const Vec& a = polygon[last];
    const Vec& b = polygon[k];
    inside ^= (a.y > y) != (b.y > y) && x < a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
  }
  return inside;
}
}

// Bugs of others that confused the two: topology-tool-kit/ttk#490, valette/ACVD#53.
TEST(InputForms, CellArraysOf32And64Bits)
{
  for (const Mesh& mesh : { makeSphere(9), makeCylinder(11) })
  {
    mesh->GetPolys()->ConvertTo64BitStorage();
    const Picture wide = pictureOf(mesh);
    mesh->GetPolys()->ConvertTo32BitStorage();
    const Picture narrow = pictureOf(mesh);
    EXPECT_SAME_BITS(wide, narrow);
  }
}

// The mesh has halves and quarters, which floats represent exactly.
TEST(InputForms, TypesAndLayoutsOfArrays)
{
  const Mesh box = makeBox(0.5, 0.75, 1.0);
  setPointNormals(box, pointsOf(box));
  const Picture expected = pictureOf(box);
  EXPECT_SAME_BITS(expected, pictureOf(withArrays<vtkFloatArray>(box)));
  EXPECT_SAME_BITS(expected, pictureOf(withArrays<vtkSOADataArrayTemplate<double>>(box)));
  EXPECT_SAME_BITS(expected, pictureOf(withArrays<vtkSOADataArrayTemplate<float>>(box)));
}

TEST(InputForms, IntegerPoints)
{
  const Mesh box = makeBox(1.0, 1.0, 1.0);
  setPointNormals(box, pointsOf(box));
  EXPECT_SAME_BITS(pictureOf(box), pictureOf(withArrays<vtkTypeInt32Array>(box)));
  EXPECT_SAME_BITS(pictureOf(box), pictureOf(withArrays<vtkTypeInt64Array>(box)));
}

TEST(InputForms, ConvexPolygonsAreFans)
{
  for (const Mesh& mesh : { makeCylinder(5), makeBox(0.5, 0.75, 1.0) })
  {
    Polygons triangles;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      mesh->GetPolys()->GetCellAtId(cell, ids);
      for (vtkIdType k = 2; k < ids->GetNumberOfIds(); ++k)
      {
        triangles.push_back({ ids->GetId(0), ids->GetId(k - 1), ids->GetId(k) });
      }
    }
    Mesh cut = Mesh::New();
    cut->ShallowCopy(mesh);
    cut->SetPolys(makeCells(triangles));
    EXPECT_SAME_BITS(pictureOf(mesh, VTK_FLAT), pictureOf(cut, VTK_FLAT));
    if (mesh->GetPointData()->GetNormals())
    {
      EXPECT_SAME_BITS(pictureOf(mesh), pictureOf(cut));
    }
  }
}

TEST(InputForms, ConcavePolygons)
{
  const std::vector<std::vector<Vec>> shapes{
    { { -1.0, -1.0, 0.0 }, { 0.0, -0.25, 0.0 }, { 1.0, -1.0, 0.0 }, { 0.0, 1.0, 0.0 } }, // arrow
    { { -1.1, -1.0, 0.0 }, { 1.0, -1.0, 0.0 }, { 1.0, -0.5, 0.0 }, { -0.5, -0.5, 0.0 },
      { -0.5, 0.5, 0.0 }, { 1.0, 0.5, 0.0 }, { 1.0, 1.0, 0.0 }, { -1.1, 1.0, 0.0 } }, // C
    { { -0.9, -1.0, 0.0 }, { -0.4, -1.0, 0.0 }, { -0.2, 0.4, 0.0 }, { 0.1, -1.0, 0.0 },
      { 0.4, 0.4, 0.0 }, { 0.6, -1.0, 0.0 }, { 1.0, -1.0, 0.0 }, { 0.9, 1.0, 0.0 },
      { -0.8, 1.0, 0.0 } } // comb
  };
  for (const std::vector<Vec>& shape : shapes)
  {
    for (std::size_t first = 0; first < shape.size(); ++first) // with any point as the first
    {
      std::vector<Vec> points(shape.begin() + static_cast<std::ptrdiff_t>(first), shape.end());
      points.insert(
        points.end(), shape.begin(), shape.begin() + static_cast<std::ptrdiff_t>(first));
      Studio studio(37, 37);
      studio.camera->ParallelProjectionOn();
      studio.camera->SetParallelScale(1.2);
      studio.tracer->SetInputData(makePolygon(points));
      studio.property->BackfaceCullingOn(); // all its triangles have the same orientation
      const Picture picture = render(studio.tracer);
      for (int j = 0; j < 37; ++j)
      {
        for (int i = 0; i < 37; ++i)
        {
          const Vec at = studio.ray(i, j).origin;
          ASSERT_EQ(picture.at(i, j) != Studio::background(), isInside(shape, at.x, at.y))
            << shape.size() << " points from " << first << ", " << pixelName(i, j);
        }
      }
    }
  }
}

TEST(InputForms, Strips)
{
  const Mesh sphere = makeSphere(9);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(sphere);
  stripper->Update();
  vtkPolyData* strips = stripper->GetOutput();
  ASSERT_GT(strips->GetNumberOfStrips(), 0);
  // VTK converts it back to triangles, in the order of the strips.
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(strips);
  triangles->Update();
  EXPECT_SAME_BITS(pictureOf(triangles->GetOutput()), pictureOf(strips));
  EXPECT_SAME_BITS(pictureOf(triangles->GetOutput(), VTK_FLAT), pictureOf(strips, VTK_FLAT));
}

// Every second triangle of a strip is stored in reverse; all have the same orientation.
TEST(InputForms, StripsHaveTheOrientationOfTheirFirstTriangle)
{
  Mesh mesh = makeMesh({ { -2.0, -2.0, 0.0 }, { -2.0, 2.0, 0.0 }, { 0.0, -2.0, 0.0 },
                         { 0.0, 2.0, 0.0 }, { 2.0, -2.0, 0.0 }, { 2.0, 2.0, 0.0 } },
    {});
  mesh->SetStrips(makeCells({ { 1, 0, 3, 2, 5, 4 } })); // counter-clockwise from +z
  Studio studio(16, 16);
  studio.tracer->SetInputData(mesh);
  studio.property->BackfaceCullingOn();
  EXPECT_EQ(render(studio.tracer).count(Studio::background()), 0);
  studio.look({ 0.0, 0.0, -5.0 }, { 0.0, 0.0, 0.0 });
  EXPECT_EQ(render(studio.tracer).count(Studio::background()), 256);
}

TEST(InputForms, PolygonsOfTwoPointsAreNotDrawn)
{
  const Mesh mesh = makeSphere(9);
  mesh->SetPolys(makeCells({ { 0, 1 }, { 5 } }));
  Studio studio;
  studio.tracer->SetInputData(mesh);
  EXPECT_EQ(render(studio.tracer).count(Studio::background()), 32 * 24);
}

// Vertices come first in the numbering of cells and cell normals, then lines, polygons and strips.
TEST(InputForms, CellNormalsFollowVerticesAndLines)
{
  // On the left and on the right: a square of two triangles, or of a triangle and a strip.
  for (int strip : { 0, 1 })
  {
    Mesh mesh = makeMesh(
      { { -9.0, -9.0, 0.0 }, { 9.0, -9.0, 0.0 }, { 9.0, 9.0, 0.0 }, { -9.0, 9.0, 0.0 } }, {});
    mesh->SetVerts(makeCells({ { 0 }, { 1 } }));
    mesh->SetLines(makeCells({ { 0, 1 } }));
    const Polygons halves{ { 0, 1, 2 }, { 0, 2, 3 } };
    mesh->SetPolys(makeCells(strip ? Polygons{ halves[0] } : halves));
    mesh->SetStrips(makeCells(strip ? Polygons{ halves[1] } : Polygons{}));
    const Vec wrong(0.0, 0.0, -1.0), lower(0.6, 0.0, 0.8), upper(0.0, -0.8, 0.6);
    setCellNormals(mesh, { wrong, wrong, wrong, lower, upper });
    Studio studio(8, 8);
    studio.property->SetInterpolationToFlat();
    studio.tracer->SetInputData(mesh);
    studio.tracer->AddLight(makeLight({ 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 }));
    const Picture picture = render(studio.tracer);
    expectColor(picture.at(6, 1), Vec(0.8), "lower right");
    expectColor(picture.at(1, 6), Vec(0.6), "upper left");
  }
}
