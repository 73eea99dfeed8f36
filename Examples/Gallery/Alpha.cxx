// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A picture with alpha a over white, black and an evening sky: c a + b (1 - a) for its colour c and
// a background b. A pixel at an edge has the colour of the surface only, so that edges are neither
// dark on white nor bright on black.

#include "Gallery.h"

#include "vtkImageAppend.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkTrivialProducer.h"

#include <cmath>

namespace
{

/// A background: the value of a channel, from 0 to 1, at the height y, also from 0 to 1.
using Background = double (*)(double y, int channel);

double White(double, int)
{
  return 1;
}

double Black(double, int)
{
  return 0;
}

/// A dark hill, and a sky from yellow to blue.
double Evening(double y, int channel)
{
  const double hill[] = { 0.09, 0.11, 0.16 };
  const double low[] = { 1, 0.8, 0.45 };
  const double high[] = { 0.16, 0.3, 0.6 };
  const double horizon = 0.3;
  const double t = (y - horizon) / (1 - horizon);
  return y < horizon ? hill[channel] : low[channel] + (high[channel] - low[channel]) * t * (2 - t);
}

vtkSmartPointer<vtkTrivialProducer> LayOver(Background background, vtkImageData* picture)
{
  vtkNew<vtkImageData> both;
  both->CopyStructure(picture);
  both->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const int* const size = both->GetDimensions();
  const auto* from = static_cast<const unsigned char*>(picture->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(both->GetScalarPointer());
  for (int pixel = 0; pixel < size[0] * size[1]; ++pixel, from += 4)
  {
    const double y = (pixel / size[0] + 0.5) / size[1]; // row 0 is at the bottom
    const double alpha = from[3] / 255.0;
    for (int channel = 0; channel < 3; ++channel)
    {
      const double behind = 255 * background(y, channel);
      *to++ =
        static_cast<unsigned char>(std::floor(from[channel] * alpha + behind * (1 - alpha) + 0.5));
    }
  }
  auto producer = vtkSmartPointer<vtkTrivialProducer>::New();
  producer->SetOutput(both);
  return producer;
}

} // namespace

int main(int argc, char* argv[])
{
  const auto property = gallery::Surface(0.95, 0.75, 0.65);
  property->SetDiffuse(0.7);
  property->SetAmbient(0.3);

  vtkNew<vtkLambentRayTracer> tracer;
  gallery::AddSurface(tracer, gallery::Ring(), property);
  gallery::AddLight(tracer, -2, 3, 3);
  gallery::LookFrom(tracer, 1, 2, 5, 240, 240);
  tracer->SetBackground(0, 0, 0); // undo LookFrom(): a picture with alpha has no background
  tracer->OutputAlphaOn();
  tracer->Update();

  vtkNew<vtkImageAppend> all;
  for (const Background background : { White, Black, Evening })
  {
    all->AddInputConnection(LayOver(background, tracer->GetOutput())->GetOutputPort());
  }
  return gallery::Save(all, "Alpha.png", argc, argv);
}
