// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces with the edges of their cells: a prism whose caps are polygons of ten corners, a sphere
// of quadrilaterals, and one of triangles with thin white edges.

#include "Gallery.h"

#include "vtkCylinderSource.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"

namespace
{

vtkSmartPointer<vtkProperty> SurfaceWithEdges(double red, double green, double blue)
{
  auto property = gallery::Surface(red, green, blue);
  property->SetAmbient(0.1);
  property->SetDiffuse(0.9);
  property->EdgeVisibilityOn();
  property->SetEdgeColor(0, 0, 0);
  property->SetLineWidth(2);
  return property;
}

} // namespace

int main(int argc, char* argv[])
{
  vtkNew<vtkLambentRayTracer> tracer;

  vtkNew<vtkCylinderSource> prism;
  prism->SetResolution(10);
  prism->SetRadius(0.95);
  prism->SetHeight(1.5);
  prism->SetCenter(-gallery::Step, 0, 0);
  const auto flat = SurfaceWithEdges(0.6, 0.8, 1);
  flat->SetInterpolationToFlat();
  gallery::AddSurface(tracer, gallery::OnGrid(prism), flat);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1);
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(11);
  sphere->LatLongTessellationOn();
  gallery::AddSurface(tracer, gallery::OnGrid(sphere), SurfaceWithEdges(1, 0.7, 0.3));

  const auto white = SurfaceWithEdges(0.2, 0.5, 0.3);
  white->SetEdgeColor(1, 1, 1);
  white->SetLineWidth(1);
  gallery::AddSurface(tracer, gallery::Sphere(gallery::Step, 0, 20), white);

  vtkNew<vtkMatrix4x4> upright; // turns the poles of the spheres from z to y
  const double rows[16] = { 1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1 };
  upright->DeepCopy(rows);
  tracer->SetInputTransform(1, upright);
  tracer->SetInputTransform(2, upright);

  gallery::AddLight(tracer, -2, 3, 2.5);
  gallery::LookFrom(tracer, 0, 3, 5, 720, 270);
  return gallery::Save(tracer, "Edges.png", argc, argv);
}
