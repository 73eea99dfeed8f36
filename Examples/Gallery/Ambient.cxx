// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ambient reflection: I = rho_d I_s max(0, cos(theta)) + rho_a I_s, for rho_a = 0, 0.1, 0.3, 0.5,
// 0.7 at rho_d = 0.6. The side away from the light gets rho_a I_s; where I reaches 1, it is white.

#include "Gallery.h"

#include "vtkNew.h"

int main(int argc, char* argv[])
{
  const double ambient[] = { 0, 0.1, 0.3, 0.5, 0.7 };
  vtkNew<vtkLambentRayTracer> tracer;
  for (int i = 0; i < 5; ++i)
  {
    const auto property = gallery::Surface(1, 1, 1);
    property->SetDiffuse(0.6);
    property->SetAmbient(ambient[i]);
    gallery::AddSurface(tracer, gallery::Sphere(gallery::Step * i), property);
  }
  gallery::AddLight(tracer, -1, 1, 0.5);
  gallery::ShowPlaces(tracer, 5, 1, 192);
  return gallery::Save(tracer, "Ambient.png", argc, argv);
}
