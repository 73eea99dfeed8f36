// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One cylinder of 16 sides, flat (left) and smooth (right). Flat: m is the normal of the face.
// Smooth: m is the interpolated point normal, m = b0 n0 + b1 n1 + b2 n2 with the barycentric
// coordinates b of the visible point (Phong). The outlines are the same; only the shading differs.

#include "Gallery.h"

#include "vtkCylinderSource.h"
#include "vtkNew.h"

int main(int argc, char* argv[])
{
  vtkNew<vtkLambentRayTracer> tracer;
  for (const bool smooth : { false, true })
  {
    vtkNew<vtkCylinderSource> cylinder; // has normals, and separate points for its caps
    cylinder->SetResolution(16);
    cylinder->SetRadius(0.9);
    cylinder->SetHeight(1.8);
    cylinder->SetCenter(smooth ? 1.25 : -1.25, 0, 0);

    const auto property = gallery::Surface(0.6, 0.8, 1);
    property->SetInterpolation(smooth ? VTK_PHONG : VTK_FLAT);
    property->SetDiffuse(0.9);
    property->SetAmbient(0.1);
    gallery::AddSurface(tracer, gallery::OnGrid(cylinder), property);
  }
  gallery::AddLight(tracer, -2, 3, 2.5);
  gallery::LookFrom(tracer, 0, 2.5, 5.5, 640, 360);
  return gallery::Save(tracer, "FlatAndSmooth.png", argc, argv);
}
