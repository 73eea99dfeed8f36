// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Diffuse reflection: I = rho_d I_s cos(theta), for rho_d = 0, 0.2, 0.4, 0.6, 0.8, 1.

#include "Gallery.h"

#include "vtkNew.h"

int main(int argc, char* argv[])
{
  vtkNew<vtkLambentRayTracer> tracer;
  for (int i = 0; i < 6; ++i)
  {
    const auto property = gallery::Surface(1, 1, 1);
    property->SetDiffuse(i / 5.0);
    gallery::AddSurface(tracer, gallery::Sphere(gallery::Step * i), property);
  }
  gallery::AddLight(tracer, -1, 1, 2);
  gallery::ShowPlaces(tracer, 6, 1, 160);
  return gallery::Save(tracer, "Diffuse.png", argc, argv);
}
