// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A box of 8 points has one normal at each, the mean of three sides, so smooth shading makes it
// look like a cushion (left). vtkLambentNormals with splitting gives each side of a sharp edge its
// own points and normals (right).

#include "Gallery.h"

#include "vtkLambentNormals.h"

#include "vtkNew.h"
#include "vtkTessellatedBoxSource.h"

int main(int argc, char* argv[])
{
  vtkNew<vtkLambentRayTracer> tracer;
  for (const bool splitting : { false, true })
  {
    const double x = splitting ? 1.25 : -1.25;
    vtkNew<vtkTessellatedBoxSource> box;
    box->SetBounds(x - 0.75, x + 0.75, -0.75, 0.75, -0.75, 0.75);
    box->DuplicateSharedPointsOff();
    box->QuadsOn();

    vtkNew<vtkLambentNormals> normals;
    normals->SetInputConnection(box->GetOutputPort());
    normals->SetSplitting(splitting);
    normals->SetFeatureAngle(30);
    normals->Update();

    const auto property = gallery::Surface(0.7, 0.9, 0.6);
    property->SetDiffuse(0.9);
    property->SetAmbient(0.1);
    gallery::AddSurface(tracer, normals->GetOutput(), property);
  }
  gallery::AddLight(tracer, 1, 5, 3);
  gallery::LookFrom(tracer, 0, 2.5, 5.5, 640, 360);
  return gallery::Save(tracer, "SharpEdges.png", argc, argv);
}
