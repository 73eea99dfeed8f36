// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lighting off (right): I = C, the colour of the surface, whatever the lights and the shape. On the
// left, the same sphere with lighting.

#include "Gallery.h"

#include "vtkNew.h"

int main(int argc, char* argv[])
{
  const auto lit = gallery::Surface(1, 0.6, 0.1);
  const auto unlit = gallery::Surface(1, 0.6, 0.1);
  unlit->LightingOff();

  vtkNew<vtkLambentRayTracer> tracer;
  gallery::AddSurface(tracer, gallery::Sphere(0), lit);
  gallery::AddSurface(tracer, gallery::Sphere(gallery::Step), unlit);
  gallery::AddLight(tracer, -1, 1, 2);
  gallery::ShowPlaces(tracer, 2, 1, 240);
  return gallery::Save(tracer, "Unlit.png", argc, argv);
}
