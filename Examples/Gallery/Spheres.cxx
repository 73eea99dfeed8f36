// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sphere sources of 8, 16 and 32 meridians, shaded smoothly with their own normals. These are the
// normals of a true sphere, so even the coarsest is shaded like one; its outline is still coarse.

#include "Gallery.h"

#include "vtkNew.h"

int main(int argc, char* argv[])
{
  vtkNew<vtkLambentRayTracer> tracer;
  for (int i = 0; i < 3; ++i)
  {
    gallery::AddSurface(
      tracer, gallery::Sphere(gallery::Step * i, 0, 8 << i), gallery::Surface(0.9, 0.9, 0.9));
  }
  gallery::AddLight(tracer, -1, 1, 2);
  gallery::ShowPlaces(tracer, 3, 1, 240);
  return gallery::Save(tracer, "Spheres.png", argc, argv);
}
