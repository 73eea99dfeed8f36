// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Passes. Left: the picture. Middle: its depth z as grey, white where the surface is nearest and
// darker with increasing distance. Right: its unit normal m as the colour (1 + m) / 2, so that red,
// green and blue increase along x, y and z. Both are NaN where no surface is hit.

#include "Gallery.h"

#include "vtkImageAppend.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <cmath>

namespace
{

/// Makes a picture of bytes of the same size. color(pixel, channel) is from 0 to 1, or NaN.
template <typename Color>
vtkSmartPointer<vtkTrivialProducer> Show(vtkImageData* picture, Color color)
{
  vtkNew<vtkImageData> shown;
  shown->CopyStructure(picture);
  shown->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* byte = static_cast<unsigned char*>(shown->GetScalarPointer());
  for (vtkIdType pixel = 0; pixel < shown->GetNumberOfPoints(); ++pixel)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      const double value = color(pixel, channel);
      *byte++ = static_cast<unsigned char>(std::isnan(value) ? 64 : std::floor(255 * value + 0.5));
    }
  }
  auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
  producer->SetOutput(shown);
  return producer;
}

} // namespace

int main(int argc, char* argv[])
{
  vtkNew<vtkLambentRayTracer> tracer;
  const auto orange = gallery::Surface(1, 0.7, 0.3);
  const auto blue = gallery::Surface(0.5, 0.8, 1);
  for (vtkProperty* const property : { orange.Get(), blue.Get() })
  {
    property->SetDiffuse(0.85);
    property->SetAmbient(0.15);
  }
  gallery::AddSurface(tracer, gallery::Ring(), orange);
  gallery::AddSurface(tracer, gallery::Sphere(0), blue);
  gallery::AddLight(tracer, 1, 3, 3);
  gallery::LookFrom(tracer, 2, 2.5, 5, 240, 240);
  tracer->GenerateDepthOn();
  tracer->GenerateNormalsOn();
  tracer->Update();

  vtkImageData* const picture = tracer->GetOutput();
  vtkDataArray* const depth = picture->GetPointData()->GetArray("Depth");
  vtkDataArray* const normals = picture->GetPointData()->GetArray("Normals");
  double range[2];
  depth->GetFiniteRange(range);
  const auto nearness = [&](vtkIdType pixel, int)
  { return 1 - 0.8 * (depth->GetTuple1(pixel) - range[0]) / (range[1] - range[0]); };
  const auto direction = [&](vtkIdType pixel, int channel)
  { return (1 + normals->GetComponent(pixel, channel)) / 2; };

  vtkNew<vtkImageAppend> all;
  all->AddInputConnection(tracer->GetOutputPort());
  all->AddInputConnection(Show(picture, nearness)->GetOutputPort());
  all->AddInputConnection(Show(picture, direction)->GetOutputPort());
  return gallery::Save(all, "Passes.png", argc, argv);
}
