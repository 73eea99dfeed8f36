// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LambentRenderer.h"

#include "Stopwatch.h"

#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkLambentNormals.h"
#include "vtkPointData.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleMeshPointNormals.h"

LambentRenderer::LambentRenderer(const BenchmarkScene& scene)
{
  vtkNew<vtkPolyData> mesh; // with arrays of its own
  mesh->ShallowCopy(scene.mesh);
  this->addArrays(mesh);
  this->Filter->SetInputData(mesh);
  this->Filter->SetInputSphereRadius(0, scene.ballRadius);
  this->Filter->SetImageSize(scene.width, scene.height);
  this->Filter->SetCamera(scene.camera);
  this->Filter->AddLight(scene.light);
  this->Filter->SetProperty(this->Property);
}

/// Adds numbers and texture coordinates that vary across the mesh.
void LambentRenderer::addArrays(vtkPolyData* mesh)
{
  vtkNew<vtkFloatArray> heights, coordinates;
  heights->SetName("Height");
  coordinates->SetNumberOfComponents(2);
  const double size = mesh->GetLength();
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k)
  {
    const double* const p = mesh->GetPoint(k);
    heights->InsertNextValue(static_cast<float>(p[1]));
    coordinates->InsertNextTuple2(4.0 * p[0] / size, 4.0 * p[1] / size);
  }
  mesh->GetPointData()->AddArray(heights);
  mesh->GetPointData()->SetTCoords(coordinates);
}

double LambentRenderer::renderLook(Look look)
{
  constexpr int side = 1024;
  if (!this->Texture->GetInput())
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(side, side, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* bytes = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int k = 0; k < 3 * side * side; ++k)
    {
      *bytes++ = static_cast<unsigned char>(k * 37 % 251);
    }
    this->Texture->SetInputData(image);
    this->Texture->InterpolateOn();
  }
  this->Filter->SetInputScalarVisibility(0, look == Look::Colors);
  this->Filter->SetInputColorArray(0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Height");
  this->Filter->SetInputTexture(0, look == Look::Texture ? this->Texture.Get() : nullptr);
  this->Property->SetEdgeVisibility(look == Look::Edges);
  const double seconds = this->render();
  this->Filter->SetInputScalarVisibility(0, false);
  this->Filter->SetInputTexture(0, nullptr);
  this->Property->EdgeVisibilityOff();
  return seconds;
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
