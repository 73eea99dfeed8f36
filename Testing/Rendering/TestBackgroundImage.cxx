// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Background images. The tests of the core compare their bits with the definition.
#include "Meshes.h"
#include "Messages.h"

#include "vtkSOADataArrayTemplate.h"
#include "vtkUnsignedCharArray.h"

namespace
{
/// An image of random numbers from 0 to 255 for bytes, or from 0 to 1.
vtkSmartPointer<vtkImageData> makeImage(
  int width, int height, int components, int type, unsigned int seed = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  vtkDataArray* const colors = image->GetPointData()->GetScalars();
  for (vtkIdType k = 0; k < colors->GetNumberOfTuples(); ++k)
  {
    for (int component = 0; component < components; ++component)
    {
      seed = seed * 1664525u + 1013904223u;
      colors->SetComponent(k, component, type == VTK_FLOAT ? (seed >> 8) * 0x1p-24 : seed >> 24);
    }
  }
  return image;
}

Picture pictureOf(vtkImageData* image, int width, int height, int type)
{
  Studio studio(width, height);
  const Messages messages(studio.tracer);
  studio.tracer->SetInputData(Mesh::New());
  const bool hasAlpha = image->GetNumberOfScalarComponents() % 2 == 0;
  studio.tracer->SetBackground(0.0, hasAlpha ? 0.5 : 0.0, hasAlpha ? 1.0 : 0.0);
  studio.tracer->SetBackgroundImage(image);
  studio.tracer->SetOutputScalarType(type);
  const Picture picture = render(studio.tracer);
  EXPECT_TRUE(messages.errors().empty());
  EXPECT_TRUE(messages.warnings().empty());
  return picture;
}

void setUp(Studio& studio, int samples)
{
  studio.look({ 2.0, 3.0, 4.0 }, { 0.0, 0.0, 0.0 });
  studio.tracer->AddInputDataObject(makeSphere(12));
  studio.tracer->SetSupersampling(samples);
}
}

TEST(BackgroundImages, AreReproducedExactlyAtThePicturesSize)
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_FLOAT })
  {
    const auto image = makeImage(47, 33, 3, type);
    EXPECT_SAME_BITS(pictureOf(image, 47, 33, type), Picture(image));
  }
}

TEST(BackgroundImages, MayBeGreyAndHaveAlpha)
{
  const double base[3] = { 0.0, 0.5, 1.0 };
  for (const int components : { 1, 2, 3, 4 })
  {
    const auto image = makeImage(9, 7, components, VTK_UNSIGNED_CHAR);
    vtkDataArray* const colors = image->GetPointData()->GetScalars();
    const Picture picture = pictureOf(image, 9, 7, VTK_FLOAT);
    for (int k = 0; k < 63; ++k)
    {
      const bool hasAlpha = components % 2 == 0;
      const double alpha = hasAlpha ? colors->GetComponent(k, components - 1) / 255.0 : 1.0;
      for (int channel = 0; channel < 3; ++channel)
      {
        const double color = colors->GetComponent(k, components > 2 ? channel : 0) / 255.0;
        EXPECT_NEAR(
          picture.at(k % 9, k / 9)[channel], alpha * color + (1.0 - alpha) * base[channel], 1e-6);
      }
    }
  }
}

// A pixel extends half its width on either side of its centre.
TEST(BackgroundImages, AreInterpolatedAtOtherSizes)
{
  const auto image = makeImage(5, 4, 3, VTK_FLOAT);
  const Picture from(image);
  const Picture picture = pictureOf(image, 37, 50, VTK_FLOAT);
  for (int j = 0; j < 50; ++j)
  {
    for (int i = 0; i < 37; ++i)
    {
      const double x = std::min(std::max((i + 0.5) / 37.0 * 5.0 - 0.5, 0.0), 4.0);
      const double y = std::min(std::max((j + 0.5) / 50.0 * 4.0 - 0.5, 0.0), 3.0);
      const int left = std::min(static_cast<int>(x), 3), low = std::min(static_cast<int>(y), 2);
      const double u = x - left, v = y - low;
      const Vec bottom = (1.0 - u) * from.at(left, low) + u * from.at(left + 1, low);
      const Vec top = (1.0 - u) * from.at(left, low + 1) + u * from.at(left + 1, low + 1);
      expectColor(picture.at(i, j), (1.0 - v) * bottom + v * top, pixelName(i, j));
    }
  }
}

// Only the pixels matter, not the image's position or its memory layout.
TEST(BackgroundImages, MayHaveAnyPositionAndLayout)
{
  const auto image = makeImage(12, 9, 3, VTK_UNSIGNED_CHAR);
  const Picture expected = pictureOf(image, 30, 20, VTK_UNSIGNED_CHAR);
  vtkNew<vtkImageData> elsewhere;
  elsewhere->ShallowCopy(image);
  elsewhere->SetExtent(5, 16, -3, 5, 7, 7);
  elsewhere->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  elsewhere->SetOrigin(1.0, 2.0, 3.0);
  elsewhere->SetSpacing(4.0, 5.0, 6.0);
  EXPECT_SAME_BITS(pictureOf(elsewhere, 30, 20, VTK_UNSIGNED_CHAR), expected);

  vtkDataArray* const colors = image->GetPointData()->GetScalars();
  vtkNew<vtkSOADataArrayTemplate<unsigned char>> apart;
  apart->SetNumberOfComponents(3);
  apart->SetNumberOfTuples(colors->GetNumberOfTuples());
  for (vtkIdType k = 0; k < colors->GetNumberOfTuples(); ++k)
  {
    apart->SetTuple(k, colors->GetTuple(k));
  }
  vtkNew<vtkImageData> inPlanes;
  inPlanes->SetDimensions(12, 9, 1);
  inPlanes->GetPointData()->SetScalars(apart);
  EXPECT_SAME_BITS(pictureOf(inPlanes, 30, 20, VTK_UNSIGNED_CHAR), expected);
}

TEST(BackgroundImages, LieBehindTheSurfaces)
{
  Studio studio(61, 45);
  setUp(studio, 1);
  const Picture without = render(studio.tracer);
  const auto image = makeImage(61, 45, 3, VTK_FLOAT);
  const Picture behind(image);
  studio.tracer->SetBackgroundImage(image);
  const Picture picture = render(studio.tracer);
  int hits = 0;
  for (int pixel = 0; pixel < 61 * 45; ++pixel)
  {
    const int i = pixel % 61, j = pixel / 61;
    const bool isHit = without.at(i, j) != Studio::background();
    EXPECT_EQ(picture.at(i, j), isHit ? without.at(i, j) : behind.at(i, j));
    hits += isHit;
  }
  EXPECT_GT(hits, 300);
}

TEST(BackgroundImages, PartsEqualThoseOfTheWhole)
{
  for (const int samples : { 1, 3 })
  {
    Studio whole(61, 45), part(61, 45);
    const auto image = makeImage(10, 70, 4, VTK_FLOAT);
    for (Studio* studio : { &whole, &part })
    {
      setUp(*studio, samples);
      studio->tracer->SetBackgroundImage(image);
    }
    const Picture expected = render(whole.tracer);
    const int extent[6] = { 9, 50, 4, 39, 0, 0 };
    part.tracer->UpdateExtent(extent);
    const Picture picture(part.tracer->GetOutput());
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      EXPECT_EQ(picture.bits(9, 51, j), expected.bits(9, 51, j)) << "row " << j;
    }
  }
}

// The image is shared with the caller. Changes to it affect the next picture, but not the last one.
TEST(BackgroundImages, ChangesAreRendered)
{
  Studio studio(8, 6);
  studio.tracer->SetInputData(Mesh::New());
  const auto image = makeImage(8, 6, 3, VTK_FLOAT, 1);
  studio.tracer->SetBackgroundImage(image);
  EXPECT_SAME_BITS(render(studio.tracer), Picture(image));
  const vtkMTimeType time = studio.tracer->GetOutput()->GetMTime();
  studio.tracer->Update();
  EXPECT_EQ(studio.tracer->GetOutput()->GetMTime(), time);

  image->GetPointData()->GetScalars()->SetComponent(7, 1, 0.625);
  image->GetPointData()->GetScalars()->Modified();
  EXPECT_SAME_BITS(render(studio.tracer), Picture(image));
  image->DeepCopy(makeImage(8, 6, 3, VTK_FLOAT, 2));
  EXPECT_SAME_BITS(render(studio.tracer), Picture(image));
  studio.tracer->SetBackgroundImage(nullptr);
  EXPECT_EQ(render(studio.tracer).count(Studio::background()), 48);
}
