// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lines and points, whose widths are in pixels: a closed curve as a tube, a wireframe on its own
// faces, and the points of a ball as small spheres.

#include "Gallery.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <cmath>

namespace
{

/// A trefoil knot as one polyline. Coordinates are rounded, as in gallery::OnGrid().
vtkSmartPointer<vtkPolyData> Knot()
{
  constexpr int Count = 1200;
  const auto round = [](double coordinate) { return std::round(coordinate * 4096) / 4096; };
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(Count + 1);
  for (int k = 0; k < Count; ++k)
  {
    const double angle = 2 * 3.14159265358979 * k / Count;
    const double across = std::sin(angle) + 2 * std::sin(2 * angle);
    const double along = std::cos(angle) - 2 * std::cos(2 * angle);
    points->InsertNextPoint(
      round(0.36 * across), round(0.36 * along), round(-0.36 * std::sin(3 * angle)));
    lines->InsertCellPoint(k);
  }
  lines->InsertCellPoint(0);
  auto knot = vtkSmartPointer<vtkPolyData>::New();
  knot->SetPoints(points);
  knot->SetLines(lines);
  return knot;
}

} // namespace

int main(int argc, char* argv[])
{
  vtkNew<vtkLambentRayTracer> tracer;

  const auto tube = gallery::Surface(0.9, 0.6, 0.2);
  tube->SetLineWidth(14);
  tube->RenderLinesAsTubesOn();
  gallery::AddSurface(tracer, Knot(), tube);

  const auto edges = gallery::Surface(0.85, 0.95, 1);
  edges->SetRepresentationToWireframe();
  edges->SetLineWidth(1.5);
  edges->LightingOff();
  const auto ball = gallery::Sphere(gallery::Step, 0, 18);
  gallery::AddSurface(tracer, ball, gallery::Surface(0.2, 0.4, 0.7));
  gallery::AddSurface(tracer, ball, edges);

  const auto dots = gallery::Surface(0.9, 0.3, 0.35);
  dots->SetRepresentationToPoints();
  dots->SetPointSize(7);
  dots->RenderPointsAsSpheresOn();
  gallery::AddSurface(tracer, gallery::Sphere(2 * gallery::Step, 0, 20), dots);

  gallery::AddLight(tracer, -1, 1, 2);
  gallery::ShowPlaces(tracer, 3, 1, 180);
  tracer->SetSupersampling(3);
  return gallery::Save(tracer, "Lines.png", argc, argv);
}
