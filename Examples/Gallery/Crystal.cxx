// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A crystal of salt. Its ions are true spheres at the points of two inputs, one for each element,
// with the radii of the ions in ångströms.

#include "Gallery.h"

#include "vtkNew.h"
#include "vtkPoints.h"

namespace
{

constexpr int Size = 4; // ions along each axis
constexpr double Spacing = 2.82;

/// The points of every other ion: those whose coordinates have an even sum, or an odd one.
vtkSmartPointer<vtkPolyData> Ions(bool even)
{
  vtkNew<vtkPoints> points;
  for (int k = 0; k < Size * Size * Size; ++k)
  {
    const int x = k % Size, y = k / Size % Size, z = k / (Size * Size);
    if (((x + y + z) % 2 == 0) == even)
    {
      const double middle = (Size - 1) / 2.0;
      points->InsertNextPoint(
        Spacing * (x - middle), Spacing * (y - middle), Spacing * (z - middle));
    }
  }
  auto ions = vtkSmartPointer<vtkPolyData>::New();
  ions->SetPoints(points);
  return ions;
}

} // namespace

int main(int argc, char* argv[])
{
  vtkNew<vtkLambentRayTracer> tracer;
  gallery::AddSurface(tracer, Ions(true), gallery::Surface(0.4, 0.8, 0.4));  // chloride
  gallery::AddSurface(tracer, Ions(false), gallery::Surface(0.7, 0.5, 0.9)); // sodium
  tracer->SetInputSphereRadius(0, 1.81);
  tracer->SetInputSphereRadius(1, 1.02);
  gallery::AddLight(tracer, -1, 2, 2);
  gallery::AddLight(tracer, 3, 1, 1, 0.25, 0.25, 0.3);
  gallery::LookFrom(tracer, 18.5, 15, 29, 360, 330);
  return gallery::Save(tracer, "Crystal.png", argc, argv);
}
