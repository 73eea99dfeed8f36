// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "Gallery.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSphereSource.h"
#include "vtkSuperquadricSource.h"

#include <cmath>
#include <cstdlib>

namespace gallery
{
namespace
{

void RoundToGrid(vtkDataArray* array)
{
  for (vtkIdType tuple = 0; tuple < array->GetNumberOfTuples(); ++tuple)
  {
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      const double value = array->GetComponent(tuple, component);
      array->SetComponent(tuple, component, std::floor(value * 4096 + 0.5) / 4096);
    }
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> OnGrid(vtkPolyDataAlgorithm* source)
{
  source->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->DeepCopy(source->GetOutput());
  RoundToGrid(mesh->GetPoints()->GetData());
  if (vtkDataArray* normals = mesh->GetPointData()->GetNormals())
  {
    RoundToGrid(normals);
  }
  return mesh;
}

vtkSmartPointer<vtkPolyData> Sphere(double x, double y, int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution / 2 + 1);
  source->SetCenter(x, y, 0);
  return OnGrid(source);
}

vtkSmartPointer<vtkPolyData> Ring()
{
  vtkNew<vtkSuperquadricSource> source;
  source->ToroidalOn();
  source->SetThetaResolution(64);
  source->SetPhiResolution(32);
  source->SetSize(1.25);
  source->SetThickness(0.25);
  return OnGrid(source);
}

vtkSmartPointer<vtkProperty> Surface(double red, double green, double blue)
{
  auto property = vtkSmartPointer<vtkProperty>::New();
  property->SetColor(red, green, blue); // both diffuse and ambient
  return property;
}

void AddSurface(vtkLambentRayTracer* tracer, vtkPolyData* mesh, vtkProperty* property)
{
  const int connection = tracer->GetNumberOfInputConnections(0);
  tracer->AddInputDataObject(0, mesh);
  tracer->SetInputProperty(connection, property);
}

void AddLight(
  vtkLambentRayTracer* tracer, double x, double y, double z, double red, double green, double blue)
{
  vtkNew<vtkLight> light; // not positional: all rays are parallel, from position to focal point
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetColor(red, green, blue);
  tracer->AddLight(light);
}

void ShowPlaces(vtkLambentRayTracer* tracer, int columns, int rows, int pixels)
{
  const double x = Step * (columns - 1) / 2;
  const double y = Step * (rows - 1) / 2;
  vtkNew<vtkCamera> camera;
  camera->ParallelProjectionOn();
  camera->SetParallelScale(Step * rows / 2);
  camera->SetFocalPoint(x, y, 0);
  camera->SetPosition(x, y, 10);
  tracer->SetCamera(camera);
  tracer->SetImageSize(columns * pixels, rows * pixels);
  tracer->SetSupersampling(3); // smooth edges
  tracer->SetBackground(0.25, 0.25, 0.25);
}

void LookFrom(vtkLambentRayTracer* tracer, double x, double y, double z, int width, int height)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(x, y, z);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewAngle(30);
  tracer->SetCamera(camera);
  tracer->SetImageSize(width, height);
  tracer->SetSupersampling(3);
  tracer->SetBackground(0.25, 0.25, 0.25);
}

int Save(vtkImageAlgorithm* picture, const char* name, int argc, char* argv[])
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argc > 1 ? argv[1] : name);
  writer->Write();
  return writer->GetErrorCode() == vtkErrorCode::NoError ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace gallery
