// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Bugs reported to other projects, as tests of this one. The reports are named as project#number.
//
// Tests elsewhere cover several of them:
//   cracks at shared edges and vertices     TestWatertight, TestContract
//   jitter at map coordinates               TestLargeCoordinates
//   another picture with more threads       TestThreads, and Testing/Reproducibility
//   cell arrays of 32 and 64 bits           TestInputForms
#include "Meshes.h"

namespace
{
const Vec axes[] = { { 1.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, -1.0, 0.0 },
  { 0.0, 0.0, 1.0 }, { 0.0, 0.0, -1.0 } };

/// A direction perpendicular to the axis.
Vec upFor(const Vec& axis)
{
  return axis.y != 0.0 ? Vec(0.0, 0.0, 1.0) : Vec(0.0, 1.0, 0.0);
}
}

// A component of 0 or -0 in the ray's direction gives infinity in a division, and 0 times infinity
// is NaN, so boxes or flat meshes are missed: madmann91/bvh#9, madmann91/bvh#20,
// jbikker/tinybvh#282, NVIDIA/warp#1530.
TEST(Pitfalls, RaysAlongAnAxis)
{
  for (int parallel : { 0, 1 })
  {
    for (const Vec& axis : axes)
    {
      for (double zero : { 0.0, -0.0 })
      {
        Studio studio(33, 33); // the rays of the middle column and row have a component 0
        studio.tracer->SetInputData(makeBox(1.0, 1.0, 1.0));
        studio.camera->SetParallelProjection(parallel);
        studio.camera->SetParallelScale(1.0); // the outermost rays are half a pixel from the edges
        studio.camera->SetViewAngle(2.0 * std::atan(0.25) * 180.0 / pi);
        studio.look(5.0 * axis + Vec(zero), Vec(zero), upFor(axis));
        EXPECT_EQ(render(studio.tracer).count(Studio::background()), 0)
          << axis.x << " " << axis.y << " " << axis.z;
      }
    }
  }
}

// The eye lies in the plane of one side of the box, and looks along that plane.
TEST(Pitfalls, RaysWithinTheSideOfABox)
{
  for (const Vec& axis : axes)
  {
    Studio studio(33, 33);
    studio.tracer->SetInputData(makeBox(1.0, 1.0, 1.0));
    studio.camera->ParallelProjectionOn();
    studio.camera->SetParallelScale(1.0);
    const Vec up = upFor(axis);
    studio.look(5.0 * axis + up, up, up); // rays of the middle row lie in the upper side
    const Picture picture = render(studio.tracer);
    for (int i = 0; i < 33; ++i)
    {
      for (int j = 0; j < 33; ++j)
      {
        EXPECT_EQ(picture.at(i, j) != Studio::background(), j <= 16) << pixelName(i, j);
      }
    }
  }
}

// Determinants grow with the square of a triangle's size. If they are compared with a fixed number,
// small triangles are lost: jbikker/tinybvh#283, g-truc/glm#1158.
TEST(Pitfalls, TinyTriangles)
{
  for (double size : { 2e-4, 1e-7, 1e-12, 1e-19 }) // vtkCamera's limit is 1e-20
  {
    for (int parallel : { 0, 1 })
    {
      Studio studio(8, 8);
      const Vec inside(size / 3.0, size / 3.0, 0.0);
      studio.tracer->SetInputData(
        makeMesh({ { 0.0, 0.0, 0.0 }, { size, 0.0, 0.0 }, { 0.0, size, 0.0 } }, { { 0, 1, 2 } }));
      studio.camera->SetParallelProjection(parallel);
      studio.camera->SetParallelScale(size / 8.0); // the view lies within the triangle
      studio.camera->SetViewAngle(10.0);
      studio.look(inside + Vec(0.0, 0.0, size), inside);
      EXPECT_EQ(render(studio.tracer).count(Studio::background()), 0) << size;
    }
  }
}

// The same from a distance: a triangle of 10^-9 of the distance, at the centre of a pixel.
TEST(Pitfalls, TinyTrianglesOnARay)
{
  for (double size : { 1e-3, 1e-6, 1e-9, 1e-12 })
  {
    Studio studio(9, 9);
    studio.tracer->SetInputData(makeMesh(
      { { -size, -size, 0.0 }, { size, -size, 0.0 }, { 0.0, size, 0.0 } }, { { 0, 1, 2 } }));
    const Picture picture = render(studio.tracer);
    EXPECT_EQ(picture.count(Studio::background()), 80) << size;
    EXPECT_NE(picture.at(4, 4), Studio::background()) << size;
  }
}

// Points move, but previously computed normals stay the same: wolph/numpy-stl#111.
TEST(Pitfalls, NormalsFollowThePoints)
{
  const Mesh grid = makeGrid(8, -4.0, -4.0);
  Studio studio, fresh;
  for (Studio* each : { &studio, &fresh })
  {
    each->look({ 1.0, 2.0, 15.0 }, { 0.0, 0.0, 0.0 });
    each->tracer->AddLight(makeLight({ 3.0, 2.0, 4.0 }, { 0.0, 0.0, 0.0 }));
  }
  studio.tracer->SetInputData(grid);
  const Picture flat = render(studio.tracer);
  vtkPoints* points = grid->GetPoints();
  for (vtkIdType p = 0; p < points->GetNumberOfPoints(); ++p)
  {
    double x[3];
    points->GetPoint(p, x);
    points->SetPoint(p, x[0], x[1], 0.1 * x[0] * x[1]);
  }
  points->Modified();
  const Picture bent = render(studio.tracer);
  fresh.tracer->SetInputData(grid);
  EXPECT_SAME_BITS(bent, render(fresh.tracer));
  EXPECT_NE(bent.bits(), flat.bits());
}

// Coincident faces flicker from pixel to pixel or from run to run. Other projects leave open which
// one a ray reports: RenderKit/embree#188, mikedh/trimesh#1338.
TEST(Pitfalls, FirstOfCoincidentFacesIsVisible)
{
  const Mesh ball = makeSphere(12);
  const Vec red(1.0, 0.0, 0.0), green(0.0, 1.0, 0.0);
  for (int first : { 0, 1 })
  {
    Studio studio(64, 48);
    studio.look({ 1.0, 2.0, 4.0 }, { 0.0, 0.0, 0.0 });
    for (int k : { first, 1 - first })
    {
      vtkNew<vtkProperty> property;
      property->LightingOff();
      property->SetDiffuseColor(k == 0 ? &red.x : &green.x);
      Mesh copy = Mesh::New();
      copy->DeepCopy(ball);
      const int input = studio.tracer->GetNumberOfInputConnections(0);
      studio.tracer->AddInputDataObject(copy);
      studio.tracer->SetInputProperty(input, property);
    }
    const Picture picture = render(studio.tracer);
    EXPECT_EQ(picture.count(first == 0 ? green : red), 0);
    EXPECT_GT(picture.count(first == 0 ? red : green), 500);
  }
}

// Seen from inside, walls are missing or dark: mitsuba-renderer/mitsuba2#132, vispy/vispy#2493.
TEST(Pitfalls, FromInsideAMeshLooksLikeOneTurnedInsideOut)
{
  const Mesh outwards = makeBox(1.0, 1.5, 2.0);
  Mesh inwards = Mesh::New();
  inwards->ShallowCopy(outwards);
  vtkNew<vtkCellArray> reversed;
  reversed->DeepCopy(outwards->GetPolys());
  for (vtkIdType cell = 0; cell < reversed->GetNumberOfCells(); ++cell)
  {
    reversed->ReverseCellAtId(cell);
  }
  inwards->SetPolys(reversed);
  Studio studios[2] = { Studio(64, 48), Studio(64, 48) };
  for (Studio& studio : studios)
  {
    studio.property->SetInterpolationToFlat();
    studio.camera->SetViewAngle(80.0);
    studio.look({ 0.3, 0.2, 1.0 }, { -0.5, -0.7, -1.0 });
    studio.tracer->AddLight(makeLight({ 0.5, 1.0, 0.75 }, { 0.0, 0.0, 0.0 }, Vec(1.0), true));
    studio.tracer->SetInputData(&studio == studios ? outwards : inwards);
  }
  const Picture expected = render(studios[1].tracer), picture = render(studios[0].tracer);
  EXPECT_EQ(picture.count(Studio::background()), 0);
  for (int j = 0; j < 48; ++j)
  {
    for (int i = 0; i < 64; ++i)
    {
      EXPECT_GT(picture.at(i, j).x, 0.0) << pixelName(i, j); // no wall faces away from the lamp
      expectColor(picture.at(i, j), expected.at(i, j), pixelName(i, j));
    }
  }
}
