// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// No ray passes between two triangles that share an edge or a vertex: a closed surface around the
// view shows not one pixel of the background. Bugs of others with cracks: RenderKit/embree#174,
// RenderKit/embree#181, jbikker/tinybvh#168, mrdoob/three.js#11449.
#include "Meshes.h"

#include <random>

namespace
{
/// The standard's generators are portable; its distributions are not.
class Random
{
public:
  double within(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Generator()) / 4294967295.0);
  }
  Vec inBox(double size)
  {
    const double x = this->within(-size, size), y = this->within(-size, size);
    return { x, y, this->within(-size, size) };
  }

private:
  std::mt19937 Generator{ 20240607 };
};

void expectNoBackground(Studio& studio, const std::string& what)
{
  EXPECT_EQ(render(studio.tracer).count(Studio::background()), 0) << what;
}
}

TEST(Watertight, ClosedMeshesFromInside)
{
  Random random;
  const Mesh meshes[] = { makeSphere(7), makeSphere(40), makeBox(1.0, 1.0, 1.0) };
  for (int k = 0; k < 60; ++k)
  {
    Studio studio(64, 48);
    studio.tracer->SetInputData(meshes[k % 3]);
    studio.camera->SetViewAngle(random.within(5.0, 170.0));
    const Vec from = random.inBox(0.5);
    studio.look(from, from + random.inBox(1.0), random.inBox(1.0));
    expectNoBackground(studio, "camera " + std::to_string(k));
    studio.camera->ParallelProjectionOn();
    studio.camera->SetParallelScale(0.05); // the eye's plane crosses the mesh
    expectNoBackground(studio, "parallel camera " + std::to_string(k));
  }
}

// Far from the origin, floats form a coarse lattice and triangles degenerate, but the mesh stays
// closed.
TEST(Watertight, ClosedMeshFarFromTheOrigin)
{
  Random random;
  const Vec far(1e7, -3e7, 5e6);
  std::vector<Vec> points = pointsOf(makeSphere(30));
  for (Vec& point : points)
  {
    point = far + 1e-3 * point;
  }
  const Mesh mesh = makeMesh(points, {});
  mesh->SetPolys(makeSphere(30)->GetPolys());
  for (int k = 0; k < 20; ++k)
  {
    Studio studio(64, 48);
    studio.tracer->SetInputData(mesh);
    const Vec from = far + random.inBox(3e-4);
    studio.look(from, from + random.inBox(1e-3), random.inBox(1.0));
    studio.camera->SetViewAngle(100.0);
    expectNoBackground(studio, "camera " + std::to_string(k));
  }
}

// The camera's axis goes exactly through a vertex or the midpoint of an edge, at the centre of the
// central pixel. The other rays pass close to the edges.
TEST(Watertight, RaysAimedAtVerticesAndEdges)
{
  const Mesh sphere = makeSphere(9);
  const std::vector<Vec> points = pointsOf(sphere);
  Studio studio(33, 33);
  studio.tracer->SetInputData(sphere);
  studio.camera->SetViewAngle(2.0);
  for (std::size_t p = 0; p + 1 < points.size(); ++p)
  {
    const Vec middle = 0.5 * (points[p] + points[p + 1]); // in the same ring, so this is an edge
    for (const Vec& target : { points[p], middle })
    {
      studio.look(Vec(0.125, 0.0, 0.0), target, { 0.3, 0.4, 1.0 });
      expectNoBackground(studio, "from inside, at point " + std::to_string(p));
      studio.look(3.0 * points[p], target, { 0.3, 0.4, 1.0 });
      expectNoBackground(studio, "from outside, at point " + std::to_string(p));
    }
  }
}

TEST(Watertight, GridWithPointsOnPixelCentres)
{
  const int n = 64;
  for (int parallel : { 0, 1 })
  {
    for (double shift : { 0.0, 0.5 }) // points on pixel centres, and between them
    {
      Studio studio(n, n);
      studio.tracer->SetInputData(makeGrid(n + 2, -n / 2 - 1.0, -n / 2 - 1.0));
      studio.look({ 0.5 + shift, 0.5, 16.0 }, { 0.5 + shift, 0.5, 0.0 });
      studio.camera->SetParallelProjection(parallel);
      studio.camera->SetParallelScale(n / 2);
      studio.camera->SetViewAngle(std::atan(n / 2 / 16.0) * 360.0 / pi);
      expectNoBackground(studio, "shift " + std::to_string(shift));
    }
  }
}

// A grid seen from random directions; the camera's axis goes exactly through one of its points.
TEST(Watertight, GridsFromAllAngles)
{
  Random random;
  for (int k = 0; k < 40; ++k)
  {
    Studio studio(48, 48);
    studio.tracer->SetInputData(makeGrid(80, -40.0, -40.0));
    const Vec target(
      std::floor(random.within(-3.0, 3.0)), std::floor(random.within(-3.0, 3.0)), 0.0);
    studio.look(target + Vec(random.within(-5.0, 5.0), random.within(-5.0, 5.0), 12.0), target,
      { std::floor(random.within(-2.0, 3.0)), 1.0, 0.0 });
    expectNoBackground(studio, "camera " + std::to_string(k));
  }
}
