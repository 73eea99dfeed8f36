// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Three glass balls that intersect each other, round an opaque cone. Front sides, back sides and
// whatever is inside are composited in order of their depth at each sample.

#include "Gallery.h"

#include "vtkConeSource.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <cmath>

namespace
{

constexpr double Pi = 3.141592653589793;

void AddGlass(vtkLambentRayTracer* tracer, int number, vtkProperty* property)
{
  const double angle = 2 * Pi * number / 3 + Pi / 2;
  vtkNew<vtkSphereSource> ball;
  ball->SetCenter(0.6 * std::cos(angle), 0.6 * std::sin(angle), 0.15 * number);
  ball->SetRadius(0.9);
  ball->SetThetaResolution(128);
  ball->SetPhiResolution(96);
  property->SetOpacity(0.35);
  gallery::AddSurface(tracer, gallery::OnGrid(ball), property);
}

} // namespace

int main(int argc, char* argv[])
{
  vtkNew<vtkLambentRayTracer> tracer;
  AddGlass(tracer, 0, gallery::Surface(0.9, 0.2, 0.2));
  AddGlass(tracer, 1, gallery::Surface(0.2, 0.8, 0.3));
  AddGlass(tracer, 2, gallery::Surface(0.2, 0.4, 1.0));
  vtkNew<vtkConeSource> cone;
  cone->SetDirection(0, 1, 0);
  cone->SetRadius(0.4);
  cone->SetHeight(0.9);
  cone->SetResolution(64);
  gallery::AddSurface(tracer, gallery::OnGrid(cone), gallery::Surface(0.9, 0.8, 0.6));
  gallery::AddLight(tracer, -2, 4, 5);
  gallery::LookFrom(tracer, 0, 0.8, 6.5, 360, 330);
  tracer->SetBackground(1, 1, 1);
  return gallery::Save(tracer, "Glass.png", argc, argv);
}
