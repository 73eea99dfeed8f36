// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Smooth surfaces without normals: edges that stay sharp, sheets that contain each face twice, and
// faces of opposite orientation.
#include "Meshes.h"

#include "vtkLambentNormals.h"

namespace
{
/// Looks at objects of about size 1 from the front, right and above.
struct Solid : Studio
{
  explicit Solid(vtkPolyData* mesh)
    : Studio(60, 45)
  {
    this->look({ 2.0, 1.5, 4.0 }, { 0.0, 0.0, 0.0 });
    this->tracer->SetInputData(mesh);
  }

  Picture bytes()
  {
    this->tracer->SetOutputScalarTypeToUnsignedChar();
    this->tracer->SetBackground(0.0, 0.0, 1.0);
    return render(this->tracer);
  }
};

/// A tube of n facets and its caps.
Mesh makeCan(int n)
{
  Mesh can = makeCylinder(n);
  can->GetPointData()->SetNormals(nullptr);
  std::vector<vtkIdType> top, bottom;
  for (vtkIdType k = 0; k < n; ++k)
  {
    top.push_back(2 * k + 1);
    bottom.push_back(2 * (n - 1 - k));
  }
  can->GetPolys()->InsertNextCell(n, top.data());
  can->GetPolys()->InsertNextCell(n, bottom.data());
  return can;
}

/// A wavy sheet of n x n quads over |x|, |y| <= 1. Each quad occurs `times` times, in alternating
/// orientations.
Mesh makeWave(int n, int times)
{
  std::vector<Vec> points;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const Vec p(2.0 * i / n - 1.0, 2.0 * j / n - 1.0, 0.0);
      points.emplace_back(p.x, p.y, 0.2 * std::sin(3.0 * p.x) * std::cos(2.0 * p.y));
    }
  }
  Polygons quads;
  for (int time = 0; time < times; ++time)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const vtkIdType a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = c - 1;
        quads.push_back(time % 2 == 0 ? std::vector<vtkIdType>{ a, b, c, d }
                                      : std::vector<vtkIdType>{ a, d, c, b });
      }
    }
  }
  return makeMesh(points, quads);
}

/// The largest difference between two pictures, in bytes.
double difference(const Picture& a, const Picture& b)
{
  double largest = 0.0;
  for (int j = 0; j < a.height(); ++j)
  {
    for (int i = 0; i < a.width(); ++i)
    {
      const Vec d = glm::abs(a.at(i, j) - b.at(i, j));
      largest = std::max({ largest, d.x, d.y, d.z });
    }
  }
  return largest;
}
}

TEST(ComputedNormals, ABoxIsFlat)
{
  Solid solid(makeBox(0.9, 0.7, 0.8));
  const Picture smooth = solid.bytes();
  solid.property->SetInterpolationToFlat();
  EXPECT_SAME_BITS(smooth, solid.bytes());
}

// The filter copies points for each side of an edge; the ray tracer does not. The bits are the
// same.
TEST(ComputedNormals, EqualTheSplittingFilters)
{
  for (Mesh mesh :
    { makeBox(0.9, 0.7, 0.8), makeCan(9), makeCan(20), makeSphere(5), makeWave(9, 1) })
  {
    mesh->GetPointData()->SetNormals(nullptr);
    Solid solid(mesh);
    for (const double angle : { 20.0, 30.0, 50.0, 120.0 })
    {
      solid.tracer->SetFeatureAngle(angle);
      solid.tracer->SetInputData(mesh);
      const Picture alone = render(solid.tracer);
      vtkNew<vtkLambentNormals> normals;
      normals->SetInputData(mesh);
      normals->SplittingOn();
      normals->SetFeatureAngle(angle + 0.0001);
      solid.tracer->SetInputConnection(normals->GetOutputPort());
      EXPECT_SAME_BITS(alone, render(solid.tracer)) << angle;
    }
  }
}

TEST(ComputedNormals, AStripHasTheEdgesOfItsTriangles)
{
  const Mesh can = makeCan(7);
  Mesh strip = makeCan(7);
  std::vector<vtkIdType> points;
  for (vtkIdType k = 0; k <= 7; ++k)
  {
    points.insert(points.end(), { 2 * (k % 7), 2 * (k % 7) + 1 });
  }
  std::reverse(points.begin(), points.end()); // otherwise its front would be inside
  vtkNew<vtkCellArray> caps;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cap : { 7, 8 })
  {
    can->GetPolys()->GetCellAtId(cap, ids);
    caps->InsertNextCell(ids);
  }
  strip->SetPolys(caps);
  strip->SetStrips(makeCells({ points }));
  Solid solid(can);
  const Picture ofPolygons = solid.bytes();
  solid.tracer->SetInputData(strip);
  EXPECT_LE(difference(ofPolygons, solid.bytes()), 1.0);
}

TEST(ComputedNormals, AreSmoothEverywhereAt180Degrees)
{
  Solid solid(makeBox(0.9, 0.7, 0.8));
  const Picture sharp = render(solid.tracer);
  solid.tracer->SetFeatureAngle(180.0);
  const Picture smooth = render(solid.tracer);
  solid.tracer->SetFeatureAngle(30.0);
  solid.tracer->SplittingOff();
  EXPECT_SAME_BITS(smooth, render(solid.tracer));
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputData(makeBox(0.9, 0.7, 0.8));
  solid.tracer->SplittingOn();
  solid.tracer->SetInputConnection(normals->GetOutputPort());
  EXPECT_SAME_BITS(smooth, render(solid.tracer));
  EXPECT_NE(sharp.bits(), smooth.bits());
}

// A sheet that contains each face twice, once in each orientation, looks like a single sheet from
// both sides.
TEST(ComputedNormals, ADoubledSheetLooksLikeASingleOne)
{
  for (const double angle : { 30.0, 180.0 })
  {
    for (const double side : { 1.0, -1.0 })
    {
      Solid solid(makeWave(24, 1));
      solid.look({ 1.0, 1.5, 4.0 * side }, { 0.0, 0.0, 0.0 });
      solid.tracer->SetFeatureAngle(angle);
      const Picture one = render(solid.tracer);
      solid.tracer->SetInputData(makeWave(24, 2));
      EXPECT_SAME_BITS(one, render(solid.tracer)) << angle;
    }
  }
}

TEST(ComputedNormals, FacesOfOppositeOrientationAreLitAlike)
{
  Mesh sheet = makeWave(24, 1);
  Solid solid(sheet);
  const Picture consistent = solid.bytes();
  Mesh mixed = makeWave(24, 2);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType k = 0; k < 576; ++k) // the orientation alternates from row to row
  {
    mixed->GetPolys()->GetCellAtId(k / 24 % 2 == 0 ? k : 576 + k, ids);
    cells->InsertNextCell(ids);
  }
  mixed->SetPolys(cells);
  solid.tracer->SetInputData(mixed);
  // Along the line between two rows, each row has its own normals.
  EXPECT_LE(difference(consistent, solid.bytes()), 12.0);
}

TEST(ComputedNormals, AMirroredMeshWithItsOwnNormalsIsLitFromOutside)
{
  const Mesh sphere = makeSphere(12);
  Mesh reversed = makeSphere(12);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> ids;
  for (vtkIdType k = 0; k < sphere->GetNumberOfPolys(); ++k)
  {
    sphere->GetPolys()->GetCellAtId(k, ids);
    const vtkIdType face[3] = { ids->GetId(0), ids->GetId(2), ids->GetId(1) };
    cells->InsertNextCell(3, face);
  }
  reversed->SetPolys(cells);
  Solid solid(sphere);
  const Picture outside = solid.bytes();
  solid.tracer->SetInputData(reversed);
  EXPECT_LE(difference(outside, solid.bytes()), 1.0);
  solid.tracer->TwoSidedLightingOff(); // the normals are then used unchanged
  EXPECT_LE(difference(outside, solid.bytes()), 1.0);
}

TEST(ComputedNormals, PartsEqualTheWhole)
{
  Solid solid(makeCan(11));
  const Picture whole = render(solid.tracer);
  const int extent[6] = { 21, 40, 10, 33, 0, 0 };
  solid.tracer->UpdateExtent(extent);
  const Picture part(solid.tracer->GetOutput());
  for (int j = 10; j <= 33; ++j)
  {
    EXPECT_EQ(part.bits(21, 41, j), whole.bits(21, 41, j)) << j;
  }
}
