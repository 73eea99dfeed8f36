// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Renders a sphere and fails unless its middle is lit and the corner is not.

#include "vtkImageData.h"
#include "vtkLambentNormals.h"
#include "vtkLambentRayTracer.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"

int main()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkLambentNormals> normals;
  normals->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkLambentRayTracer> tracer;
  tracer->SetInputConnection(normals->GetOutputPort());
  tracer->SetImageSize(33, 33);
  tracer->Update();

  vtkImageData* image = tracer->GetOutput();
  const double middle = image->GetScalarComponentAsDouble(16, 16, 0, 0);
  const double corner = image->GetScalarComponentAsDouble(0, 0, 0, 0);
  return middle > 200.0 && corner == 0.0 ? 0 : 1;
}
