// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief an unlit white rectangle with a texture, seen so that its unit of length is a pixel
 */
#ifndef TexturedQuad_h
#define TexturedQuad_h

#include "Picture.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

/// A rectangle with texture coordinates from (s0, t0) at the lower left to (s1, t1).
inline vtkSmartPointer<vtkPolyData> makeQuad(
  int width, int height, double s0 = 0.0, double t0 = 0.0, double s1 = 1.0, double t1 = 1.0)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> coordinates;
  vtkNew<vtkCellArray> cells;
  coordinates->SetName("Places");
  coordinates->SetNumberOfComponents(2);
  const double corners[4][2] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
  for (const auto& corner : corners)
  {
    points->InsertNextPoint(corner[0] * width, corner[1] * height, 0.0);
    coordinates->InsertNextTuple2(s0 + (s1 - s0) * corner[0], t0 + (t1 - t0) * corner[1]);
  }
  const vtkIdType ids[4] = { 0, 1, 2, 3 };
  cells->InsertNextCell(4, ids);
  auto quad = vtkSmartPointer<vtkPolyData>::New();
  quad->SetPoints(points);
  quad->SetPolys(cells);
  quad->GetPointData()->SetTCoords(coordinates);
  return quad;
}

struct TexturedQuad
{
  vtkNew<vtkLambentRayTracer> tracer;
  vtkNew<vtkTexture> texture;
  vtkNew<vtkProperty> property;
  vtkNew<vtkCamera> camera;
  vtkSmartPointer<vtkPolyData> quad;

  TexturedQuad(
    int width, int height, double s0 = 0.0, double t0 = 0.0, double s1 = 1.0, double t1 = 1.0)
    : quad(makeQuad(width, height, s0, t0, s1, t1))
  {
    this->camera->ParallelProjectionOn();
    this->camera->SetParallelScale(0.5 * height);
    this->camera->SetFocalPoint(0.5 * width, 0.5 * height, 0.0);
    this->camera->SetPosition(0.5 * width, 0.5 * height, 1.0);
    this->property->LightingOff();
    this->tracer->SetImageSize(width, height);
    this->tracer->SetCamera(this->camera);
    this->tracer->SetProperty(this->property);
    this->tracer->SetInputData(this->quad);
    this->tracer->SetInputTexture(0, this->texture);
  }
};

/// An image of random numbers: of the whole range of integers, or from 0 to 1. Alpha is the
/// largest.
inline vtkSmartPointer<vtkImageData> makeImage(
  int width, int height, int components, int type = VTK_UNSIGNED_CHAR)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  vtkDataArray* const pixels = image->GetPointData()->GetScalars();
  const double largest = type == VTK_FLOAT || type == VTK_DOUBLE ? 1.0 : pixels->GetDataTypeMax();
  unsigned int state = 1;
  for (vtkIdType k = 0; k < pixels->GetNumberOfTuples(); ++k)
  {
    for (int c = 0; c < components; ++c)
    {
      state = state * 1664525u + 1013904223u;
      const bool isAlpha = components % 2 == 0 && c == components - 1; // opaque
      pixels->SetComponent(k, c, isAlpha ? largest : largest * (state >> 16) / 65535.0);
    }
  }
  return image;
}

/// The bytes of a pixel's colour, for an image of bytes that has 1 to 4 components.
inline Vec colorOf(vtkImageData* image, int i, int j)
{
  vtkDataArray* const pixels = image->GetPointData()->GetScalars();
  const vtkIdType k = static_cast<vtkIdType>(j) * image->GetDimensions()[0] + i;
  const bool isGrey = pixels->GetNumberOfComponents() < 3;
  return { pixels->GetComponent(k, 0), pixels->GetComponent(k, isGrey ? 0 : 1),
    pixels->GetComponent(k, isGrey ? 0 : 2) };
}

/// Expects image(at(i, j)) at each pixel of the picture.
template <typename At>
void expectImage(TexturedQuad& scene, vtkImageData* image, const At& at)
{
  const Picture picture = render(scene.tracer);
  ASSERT_FALSE(picture.empty());
  for (int j = 0; j < picture.height(); ++j)
  {
    for (int i = 0; i < picture.width(); ++i)
    {
      const auto [column, row] = at(i, j);
      ASSERT_EQ(picture.at(i, j), colorOf(image, column, row)) << pixelName(i, j);
    }
  }
}

#endif
