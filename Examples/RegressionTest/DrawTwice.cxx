// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a test program that renders a picture itself: the filter applied to its own output
 */

#include "vtkStellate.h"

#include "vtkCamera.h"
#include "vtkLambentRayTracer.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkProperty.h"
#include "vtkXMLPolyDataReader.h"

#include <cstdlib>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkStellate> first, second;
  first->SetInputConnection(reader->GetOutputPort());
  second->SetInputConnection(first->GetOutputPort());
  second->SetHeight(0.25);

  vtkNew<vtkCamera> camera;
  camera->SetPosition(6, 4, 5);
  vtkNew<vtkProperty> surface;
  surface->SetInterpolationToFlat();
  surface->SetColor(0.8, 0.6, 1);
  vtkNew<vtkLambentRayTracer> tracer;
  tracer->SetInputConnection(second->GetOutputPort());
  tracer->SetCamera(camera);
  tracer->SetProperty(surface);
  tracer->SetImageSize(128, 128);

  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(tracer->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write();
  return EXIT_SUCCESS;
}
