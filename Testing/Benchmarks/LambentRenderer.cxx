// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LambentRenderer.h"

#include "Stopwatch.h"

#include "vtkLambentNormals.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleMeshPointNormals.h"

LambentRenderer::LambentRenderer(const BenchmarkScene& scene)
{
  this->Filter->SetInputData(scene.mesh);
  this->Filter->SetImageSize(scene.width, scene.height);
  this->Filter->SetCamera(scene.camera);
  this->Filter->AddLight(scene.light);
  this->Filter->SetProperty(this->Property);
}

double LambentRenderer::renderLayers()
{
  this->Property->SetOpacity(layerOpacity);
  const double seconds = this->render();
  this->Property->SetOpacity(1.0);
  return seconds;
}

double LambentRenderer::render(int samples)
{
  this->Filter->SetSupersampling(samples);
  this->Filter->GetOutput()->Initialize(); // Freeing the last image does not count.
  this->Filter->Modified();
  const Stopwatch stopwatch;
  this->Filter->Update();
  return stopwatch.seconds();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> withoutNormals(vtkPolyData* mesh)
{
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(mesh->GetPolys());
  return bare;
}

namespace
{
double timeOf(vtkAlgorithm* filter, vtkPolyData* mesh)
{
  filter->SetInputDataObject(mesh);
  const Stopwatch stopwatch;
  filter->Update();
  return stopwatch.seconds();
}
}

double computeNormals(NormalsFilter filter, vtkPolyData* mesh)
{
  switch (filter)
  {
    case NormalsFilter::Lambent:
    {
      vtkNew<vtkLambentNormals> normals;
      return timeOf(normals, mesh);
    }
    case NormalsFilter::PolyData:
    {
      vtkNew<vtkPolyDataNormals> normals;
      normals->SplittingOff();
      normals->ConsistencyOff();
      return timeOf(normals, mesh);
    }
    default:
    {
      vtkNew<vtkTriangleMeshPointNormals> normals;
      return timeOf(normals, mesh);
    }
  }
}
