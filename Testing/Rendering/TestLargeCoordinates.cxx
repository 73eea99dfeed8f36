// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Small objects far from the origin: map coordinates of 10^7 with features of 10^-3. If an offset
// loses no bit of any coordinate, the moved scene gives the same bits as at the origin, since all
// positions are taken relative to the eye. Bugs of others with jitter in such scenes:
// Kitware/vtk-js#1217, OPM/ResInsight#2578, RobotLocomotion/drake#2244.
#include "Meshes.h"

namespace
{
constexpr double unit = 1.0 / 1024.0 / 1024.0; // about 10^-6; 10^7 in units is 2^43.3

double snapped(double x, double step)
{
  return std::round(x / step) * step;
}

/// A sphere of a given radius whose coordinates are whole units, moved by an offset.
Mesh makeSnappedSphere(double radius, const Vec& offset)
{
  const Mesh sphere = makeSphere(16);
  std::vector<Vec> points = pointsOf(sphere);
  for (Vec& p : points)
  {
    p = Vec(snapped(radius * p.x, unit), snapped(radius * p.y, unit), snapped(radius * p.z, unit)) +
      offset;
  }
  Mesh mesh = makeMesh(points, {});
  mesh->SetPolys(sphere->GetPolys());
  return mesh;
}

Picture picture(const Vec& offset, int interpolation, int parallel)
{
  const double radius = 1.0 / 1024.0; // a millimetre
  Studio studio(65, 49);
  studio.property->SetInterpolation(interpolation);
  studio.camera->SetParallelProjection(parallel);
  studio.camera->SetParallelScale(1.25 * radius);
  studio.look(offset + radius * Vec(2.0, 1.0, 4.0), offset + radius * Vec(0.0, 0.0, 0.125),
    { 0.25, 1.0, 0.0 });
  studio.tracer->SetInputData(makeSnappedSphere(radius, offset));
  studio.tracer->AddLight(
    makeLight(offset + radius * Vec(3.0, 5.0, 2.0), offset, Vec(1.0, 0.75, 0.5), true));
  studio.tracer->AddLight(
    makeLight(offset + radius * Vec(-3.0, 1.0, 2.0), offset, Vec(0.125, 0.25, 0.5)));
  return render(studio.tracer);
}
}

TEST(LargeCoordinates, LoseNoPrecision)
{
  const Vec far(12345678.0, -9876543.0, 10000001.0);
  for (int interpolation : { VTK_FLAT, VTK_PHONG })
  {
    for (int parallel : { 0, 1 })
    {
      const Picture here = picture(Vec(0.0), interpolation, parallel);
      const Picture there = picture(far, interpolation, parallel);
      EXPECT_SAME_BITS(here, there);
      const int background = here.count(Studio::background());
      EXPECT_GT(background, 400);
      EXPECT_LT(background, 65 * 49 - 400);
    }
  }
}

// A scene twice as large gives the same picture: no length is built in.
TEST(LargeCoordinates, ScaleDoesNotMatter)
{
  const auto pictureOf = [](double scale)
  {
    Studio studio(65, 49);
    std::vector<Vec> points = pointsOf(makeSphere(16));
    for (Vec& point : points)
    {
      point *= scale;
    }
    Mesh mesh = makeMesh(points, {});
    mesh->SetPolys(makeSphere(16)->GetPolys());
    studio.look(scale * Vec(1.0, 2.0, 4.0), Vec(0.0));
    studio.tracer->SetInputData(mesh);
    studio.tracer->AddLight(makeLight(scale * Vec(3.0, 5.0, 2.0), Vec(0.0), Vec(1.0), true));
    return render(studio.tracer);
  };
  const Picture one = pictureOf(1.0);
  for (int exponent : { -60, -20, 1, 20, 60 })
  {
    EXPECT_SAME_BITS(one, pictureOf(std::ldexp(1.0, exponent))) << "2^" << exponent;
  }
}

// Distant points in single precision, as in most files, appear where their floats are.
TEST(LargeCoordinates, FloatPoints)
{
  Studio studio(64, 48);
  const Vec far(16777216.0, 0.0, 0.0); // beyond this, floats are 2 apart
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  for (const Vec& p :
    { Vec(0.0, 0.0, 0.0), Vec(8.0, 0.0, 0.0), Vec(8.0, 8.0, 0.0), Vec(0.0, 8.0, 0.0) })
  {
    points->InsertNextPoint(far.x + p.x, far.y + p.y, far.z + p.z);
  }
  Mesh mesh = Mesh::New();
  mesh->SetPoints(points);
  mesh->SetPolys(makeCells({ { 0, 1, 2, 3 } }));
  studio.camera->ParallelProjectionOn();
  studio.camera->SetParallelScale(12.0); // half a unit per pixel
  studio.look(far + Vec(0.0, 0.0, 5.0), far);
  studio.tracer->SetInputData(mesh);
  const Picture picture = render(studio.tracer);
  for (int j = 0; j < 48; ++j)
  {
    for (int i = 0; i < 64; ++i)
    {
      const bool inside = i >= 32 && i < 48 && j >= 24 && j < 40;
      EXPECT_EQ(picture.at(i, j) != Studio::background(), inside) << pixelName(i, j);
    }
  }
}
