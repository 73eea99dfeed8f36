// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Coloured light on coloured surfaces: I = rho_d I_s cos(theta), separately in each channel. From
// left to right white, red, green, blue and orange surfaces; from top to bottom white, red, green
// and blue light. A red surface reflects no green light, so it appears black.

#include "Gallery.h"

#include "vtkImageAppend.h"
#include "vtkNew.h"

int main(int argc, char* argv[])
{
  const double surfaces[][3] = { { 1, 1, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0.5, 0 } };
  const double lights[][3] = { { 1, 1, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

  vtkNew<vtkImageAppend> rows;
  rows->SetAppendAxis(1);
  for (int row = 3; row >= 0; --row) // the bottom row first
  {
    vtkNew<vtkLambentRayTracer> tracer;
    for (int i = 0; i < 5; ++i)
    {
      gallery::AddSurface(tracer, gallery::Sphere(gallery::Step * i),
        gallery::Surface(surfaces[i][0], surfaces[i][1], surfaces[i][2]));
    }
    gallery::AddLight(tracer, -1, 1, 2, lights[row][0], lights[row][1], lights[row][2]);
    gallery::ShowPlaces(tracer, 5, 1, 128);
    rows->AddInputConnection(tracer->GetOutputPort());
  }
  return gallery::Save(rows, "ColouredLight.png", argc, argv);
}
