// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLambentRayTracer.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkProperty.h"
#include "vtkXMLPolyDataReader.h"

int main()
{
  vtkNew<vtkXMLPolyDataReader> mesh;
  mesh->SetFileName("Data/seashell.vtp");

  vtkNew<vtkCamera> camera;
  camera->SetPosition(0, 0, 7.25);
  camera->SetFocalPoint(0, 0, 0);

  vtkNew<vtkLight> evening; // infinitely far away, like the sun
  evening->SetPosition(-5, 6, 7);
  evening->SetColor(1, 0.7, 0.4);

  vtkNew<vtkLight> sky;
  sky->SetPosition(7, -1, 2.5);
  sky->SetColor(0.2, 0.4, 1);

  vtkNew<vtkProperty> surface;
  surface->SetDiffuse(0.95);
  surface->SetAmbient(0.05);

  vtkNew<vtkLambentRayTracer> tracer;
  tracer->SetInputConnection(mesh->GetOutputPort());
  tracer->SetProperty(surface);
  tracer->SetFeatureAngle(180); // smooth everywhere: its ribs are round
  tracer->SetCamera(camera);
  tracer->AddLight(evening);
  tracer->AddLight(sky);
  tracer->SetImageSize(960, 540);
  tracer->SetSupersampling(3); // 3 x 3 samples per pixel: smooth edges

  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(tracer->GetOutputPort());
  writer->SetFileName("seashell.png");
  writer->Write();
  return 0;
}
