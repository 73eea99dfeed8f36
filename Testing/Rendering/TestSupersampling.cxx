// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// What the filter adds to the core's supersampling: the setting, parts of the image, and the ids.
// The core's tests check that the averages are exact.
#include "Meshes.h"

#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

namespace
{
constexpr int width = 31, height = 23;

/// A ball and a box on a gradient.
void setUp(Studio& studio, int samples)
{
  studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
  studio.tracer->AddInputDataObject(makeSphere(12));
  studio.tracer->AddInputDataObject(makeBox(0.8, 0.9, 0.7));
  studio.tracer->SetBackground2(0.5, 0.6, 0.7);
  studio.tracer->GradientBackgroundOn();
  studio.tracer->SetSupersampling(samples);
}

vtkIdType idAt(vtkImageData* image, const char* name, int i, int j)
{
  auto* const ids = vtkIdTypeArray::SafeDownCast(image->GetPointData()->GetArray(name));
  return ids->GetValue(static_cast<vtkIdType>(j) * image->GetDimensions()[0] + i);
}
}

TEST(Supersampling, AveragesTheLargerPicture)
{
  for (const int n : { 2, 3, 4, 7 })
  {
    Studio studio(width, height), larger(n * width, n * height);
    setUp(studio, n);
    setUp(larger, 1);
    const Picture picture = render(studio.tracer), samples = render(larger.tracer);
    for (int pixel = 0; pixel < width * height; ++pixel)
    {
      const int i = pixel % width, j = pixel / width;
      Vec sum(0.0);
      for (int k = 0; k < n * n; ++k)
      {
        sum += samples.at(n * i + k % n, n * j + k / n);
      }
      const Vec difference = glm::abs(picture.at(i, j) - sum / static_cast<double>(n * n));
      EXPECT_LT(std::max({ difference.x, difference.y, difference.z }), 2e-7) // samples are floats
        << n << " samples, pixel " << i << ", " << j;
    }
  }
}

TEST(Supersampling, PartsEqualTheWhole)
{
  Studio studio(width, height);
  setUp(studio, 3);
  const Picture whole = render(studio.tracer);
  Studio part(width, height);
  setUp(part, 3);
  const int extent[6] = { 5, 22, 3, 17, 0, 0 };
  part.tracer->UpdateExtent(extent);
  const Picture picture(part.tracer->GetOutput());
  for (int j = extent[2]; j <= extent[3]; ++j)
  {
    EXPECT_EQ(picture.bits(extent[0], extent[1] + 1, j), whole.bits(extent[0], extent[1] + 1, j));
  }
}

// The ids are those of the central sample, since ids cannot be averaged.
TEST(Supersampling, IdsComeFromTheCentralSample)
{
  for (const int n : { 2, 3 })
  {
    Studio studio(width, height), larger(n * width, n * height);
    setUp(studio, n);
    setUp(larger, 1);
    for (Studio* each : { &studio, &larger })
    {
      each->tracer->GenerateIdsOn();
      each->tracer->Update();
    }
    for (int pixel = 0; pixel < width * height; ++pixel)
    {
      const int i = pixel % width, j = pixel / width;
      for (const char* name : { "CellIds", "InputIds" })
      {
        EXPECT_EQ(idAt(studio.tracer->GetOutput(), name, i, j),
          idAt(larger.tracer->GetOutput(), name, n * i + n / 2, n * j + n / 2));
      }
    }
  }
}

// A square covers half of the width of a pixel, whose value lies between square and background.
TEST(Supersampling, SmoothsEdges)
{
  Studio studio(4, 1);
  studio.camera->ParallelProjectionOn();
  studio.camera->SetParallelScale(0.5);
  studio.property->LightingOff();
  studio.property->SetColor(1.0, 1.0, 1.0);
  studio.tracer->SetBackground(0.0, 0.0, 0.0);
  studio.tracer->SetInputData(
    makeMesh({ { -3.0, -1.0, 0.0 }, { 0.5, -1.0, 0.0 }, { 0.5, 1.0, 0.0 }, { -3.0, 1.0, 0.0 } },
      { { 0, 1, 2, 3 } }));
  studio.tracer->SetSupersampling(4);
  const Picture picture = render(studio.tracer);
  EXPECT_EQ(picture.at(1, 0), Vec(1.0));
  EXPECT_EQ(picture.at(2, 0), Vec(0.5));
  EXPECT_EQ(picture.at(3, 0), Vec(0.0));
}
