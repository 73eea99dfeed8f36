// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights add up: I is the sum over the lights of rho_d I_k cos(theta_k). On the left, a red and a
// green light; on the right, a blue one as well. The surface is white.

#include "Gallery.h"

#include "vtkImageAppend.h"
#include "vtkNew.h"

int main(int argc, char* argv[])
{
  vtkNew<vtkImageAppend> both;
  for (const int count : { 2, 3 })
  {
    vtkNew<vtkLambentRayTracer> tracer;
    gallery::AddSurface(tracer, gallery::Sphere(0), gallery::Surface(1, 1, 1));
    gallery::AddLight(tracer, -2, 1, 2, 1, 0, 0);
    gallery::AddLight(tracer, 2, 1, 2, 0, 1, 0);
    if (count == 3)
    {
      gallery::AddLight(tracer, 0, -2, 2, 0, 0, 1);
    }
    gallery::ShowPlaces(tracer, 1, 1, 320);
    both->AddInputConnection(tracer->GetOutputPort());
  }
  return gallery::Save(both, "AddingLights.png", argc, argv);
}
