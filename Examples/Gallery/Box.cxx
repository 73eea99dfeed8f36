// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flat shading: m is the normal of the face, so with an infinitely distant light s.m is constant
// on each side of a box.

#include "Gallery.h"

#include "vtkCubeSource.h"
#include "vtkNew.h"

int main(int argc, char* argv[])
{
  vtkNew<vtkCubeSource> box;
  box->SetXLength(2);
  box->SetYLength(1.25);
  box->SetZLength(1.5);

  const auto property = gallery::Surface(1, 0.75, 0.3);
  property->SetInterpolationToFlat();
  property->SetDiffuse(0.9);
  property->SetAmbient(0.1);

  vtkNew<vtkLambentRayTracer> tracer;
  gallery::AddSurface(tracer, gallery::OnGrid(box), property);
  gallery::AddLight(tracer, 1, 5, 3);
  gallery::LookFrom(tracer, 3.5, 3, 5, 480, 360);
  return gallery::Save(tracer, "Box.png", argc, argv);
}
