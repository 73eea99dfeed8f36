// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One image of 8 x 8 pixels on three balls, projected along z. Left: its pixels. Middle: they are
// interpolated. Right: three times smaller, so that it is repeated, every other time mirrored. The
// colour of the texture multiplies that of the lit ball.

#include "Gallery.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

namespace
{

/// Squares from blue over violet to orange, and pale ones between them.
vtkSmartPointer<vtkImageData> Squares()
{
  const int size = 8;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int j = 0; j < size; ++j)
  {
    for (int i = 0; i < size; ++i)
    {
      const bool isPale = (i + j) % 2 != 0;
      auto* const pixel = static_cast<unsigned char*>(image->GetScalarPointer(i, j, 0));
      pixel[0] = static_cast<unsigned char>(isPale ? 250 : 40 + 30 * i);
      pixel[1] = static_cast<unsigned char>(isPale ? 240 : 40 + 16 * j);
      pixel[2] = static_cast<unsigned char>(isPale ? 220 : 220 - 24 * i);
    }
  }
  return image;
}

/// Texture coordinates that project the image on a ball.
void Project(vtkPolyData* ball, double center)
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (vtkIdType k = 0; k < ball->GetNumberOfPoints(); ++k)
  {
    const double* const p = ball->GetPoint(k);
    coordinates->InsertNextTuple2((p[0] - center + 1) / 2, (p[1] + 1) / 2);
  }
  ball->GetPointData()->SetTCoords(coordinates);
}

} // namespace

int main(int argc, char* argv[])
{
  const auto property = gallery::Surface(1, 1, 1);
  property->SetDiffuse(0.85);
  property->SetAmbient(0.15);
  const auto image = Squares();
  vtkNew<vtkTransform> smaller;
  smaller->Scale(3, 3, 1);

  vtkNew<vtkLambentRayTracer> tracer;
  for (int k = 0; k < 3; ++k)
  {
    vtkNew<vtkTexture> texture;
    texture->SetInputData(image);
    texture->SetInterpolate(k == 1);
    if (k == 2)
    {
      texture->SetTransform(smaller);
      texture->SetWrap(vtkTexture::MirroredRepeat);
    }
    const auto ball = gallery::Sphere(k * gallery::Step);
    Project(ball, k * gallery::Step);
    gallery::AddSurface(tracer, ball, property);
    tracer->SetInputTexture(k, texture);
  }
  gallery::AddLight(tracer, -2, 3, 4);
  gallery::ShowPlaces(tracer, 3, 1, 240);
  return gallery::Save(tracer, "Textures.png", argc, argv);
}
