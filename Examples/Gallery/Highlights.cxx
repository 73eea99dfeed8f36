// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Highlights: I = rho_d I_s cos(theta) + rho_s I_s max(0, cos(alpha))^p, where alpha is the angle
// between the reflected light and the direction to the viewer, for p = 1, 4, 16, 64 and 128.

#include "Gallery.h"

#include "vtkNew.h"

int main(int argc, char* argv[])
{
  const double powers[] = { 1, 4, 16, 64, 128 };
  vtkNew<vtkLambentRayTracer> tracer;
  for (int i = 0; i < 5; ++i)
  {
    const auto property = gallery::Surface(0.1, 0.3, 0.6);
    property->SetSpecular(0.8);
    property->SetSpecularColor(1, 1, 1); // SetColor() has set this, too
    property->SetSpecularPower(powers[i]);
    gallery::AddSurface(tracer, gallery::Sphere(gallery::Step * i), property);
  }
  gallery::AddLight(tracer, -1, 1, 2);
  gallery::ShowPlaces(tracer, 5, 1, 160);
  return gallery::Save(tracer, "Highlights.png", argc, argv);
}
