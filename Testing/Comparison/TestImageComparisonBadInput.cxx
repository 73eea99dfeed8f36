// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An impossible comparison does not pass, whatever was compared before.

#include "ComparedImages.h"

#include "../Rendering/Messages.h"

#include "vtkBitArray.h"
#include "vtkLambentRayTracer.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{

void expectFailure(vtkImageData* picture, vtkImageData* baseline, const std::string& words)
{
  vtkNew<vtkLambentImageComparison> comparison;
  compareIn(comparison, grey(2, 2), grey(2, 2));
  ASSERT_TRUE(comparison->GetPassed());
  const Messages messages(comparison);
  compareIn(comparison, picture, baseline, 255.0);
  EXPECT_FALSE(comparison->GetPassed());
  expectMessage(messages.errors(), { words });
  EXPECT_NE(std::string(comparison->GetMessage()).find(words), std::string::npos)
    << comparison->GetMessage();
  EXPECT_EQ(comparison->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ImageComparisonBadInput, EmptyPicturesAreNotTheSame)
{
  vtkNew<vtkImageData> nothing;
  EXPECT_FALSE(compare(nothing, nothing)->GetPassed());
  EXPECT_STREQ(compare(nothing, grey(2, 2))->GetMessage(), "the picture is empty");
  EXPECT_STREQ(compare(grey(2, 2), nothing)->GetMessage(), "the baseline is empty");
}

TEST(ImageComparisonBadInput, VolumesAreNotPictures)
{
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(2, 2, 2);
  volume->AllocateScalars(VTK_FLOAT, 1);
  const auto c = compare(volume, volume);
  EXPECT_FALSE(c->GetPassed());
  EXPECT_STREQ(c->GetMessage(),
    "the images are 2 x 2 x 2, 1 component of float; a picture has a single slice");
}

TEST(ImageComparisonBadInput, NoScalars)
{
  const auto bare = grey(2, 2);
  bare->GetPointData()->SetActiveScalars(nullptr);
  expectFailure(bare, grey(2, 2), "The picture has no active point scalars");
  expectFailure(grey(2, 2), bare, "The baseline has no active point scalars");
}

TEST(ImageComparisonBadInput, TooFewScalars)
{
  const auto image = grey(2, 2);
  vtkNew<vtkUnsignedCharArray> few;
  few->SetNumberOfComponents(3);
  few->SetNumberOfTuples(3);
  few->Fill(0);
  image->GetPointData()->SetScalars(few);
  expectFailure(image, grey(2, 2), "The picture has 3 scalars for 4 pixels");
  expectFailure(grey(2, 2), image, "The baseline has 3 scalars for 4 pixels");
}

TEST(ImageComparisonBadInput, BitsAreNotNumbers)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  vtkNew<vtkBitArray> bits;
  bits->SetNumberOfTuples(4);
  image->GetPointData()->SetScalars(bits);
  expectFailure(image, image, "cannot be compared");
}

TEST(ImageComparisonBadInput, WrongToleranceKeepsTheOldOne)
{
  vtkNew<vtkLambentImageComparison> comparison;
  comparison->SetTolerance(2.0);
  const Messages messages(comparison);
  for (const double wrong :
    { -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    comparison->SetTolerance(wrong);
    EXPECT_EQ(comparison->GetTolerance(), 2.0);
  }
  EXPECT_EQ(messages.errors().size(), 3u);
}

// The tracer fails in an early or a late pass, and the comparison is not executed.
TEST(ImageComparisonBadInput, FailedInputsDoNotPass)
{
  for (const bool isLate : { false, true })
  {
    vtkNew<vtkLambentRayTracer> tracer;
    tracer->SetInputData(vtkNew<vtkPolyData>());
    tracer->SetImageSize(4, 4);
    vtkNew<vtkLambentImageComparison> comparison;
    comparison->SetInputConnection(0, tracer->GetOutputPort());
    comparison->SetInputData(1, values<unsigned char>(4, 4, 3));
    comparison->Update();
    ASSERT_TRUE(comparison->GetPassed()) << comparison->GetMessage();

    const Messages messages(tracer);
    if (isLate)
    {
      tracer->SetBackground(std::numeric_limits<double>::quiet_NaN(), 0, 0);
    }
    else
    {
      tracer->SetImageSize(0, 4);
    }
    comparison->Update();
    EXPECT_EQ(messages.errors().size(), 1u);
    EXPECT_FALSE(comparison->GetPassed());
  }
}

} // namespace
