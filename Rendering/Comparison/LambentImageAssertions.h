// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief GoogleTest assertions for images
 *
 *     EXPECT_IMAGES_EQ(image, expected);        // no value may differ
 *     EXPECT_IMAGES_NEAR(image, expected, 2.0); // none by more than 2
 *
 * and ASSERT_IMAGES_EQ, ASSERT_IMAGES_NEAR. They take vtkImageData*, vtkNew<vtkImageData> and
 * vtkSmartPointer<vtkImageData>, compare with vtkLambentImageComparison, and fail with its
 * message: "17 of 90000 pixels differ, by at most 3 of 255; the first is (12, 40)".
 * nullptr fails.
 *
 * Link Lambent::Lambent and GoogleTest.
 */

#ifndef LambentImageAssertions_h
#define LambentImageAssertions_h

#include "vtkImageData.h"
#include "vtkLambentImageComparison.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

inline testing::AssertionResult lambentImagesNear(const char* imageText, const char* expectedText,
  const char*, vtkImageData* image, vtkImageData* expected, double tolerance)
{
  const auto failure = [&]()
  { return testing::AssertionFailure() << imageText << " is not " << expectedText << ": "; };
  if (!image || !expected)
  {
    return failure() << (image ? expectedText : imageText) << " is nullptr";
  }
  if (!(tolerance >= 0.0))
  {
    return failure() << "a tolerance of " << tolerance << " is negative or not a number";
  }
  vtkNew<vtkLambentImageComparison> comparison;
  comparison->SetPictureData(image);
  comparison->SetBaselineData(expected);
  comparison->SetTolerance(tolerance);
  comparison->Update();
  return comparison->GetPassed() ? testing::AssertionSuccess()
                                 : failure() << comparison->GetMessage();
}

inline testing::AssertionResult lambentImagesEqual(
  const char* imageText, const char* expectedText, vtkImageData* image, vtkImageData* expected)
{
  return lambentImagesNear(imageText, expectedText, "", image, expected, 0.0);
}

#define EXPECT_IMAGES_EQ(image, expected) EXPECT_PRED_FORMAT2(lambentImagesEqual, image, expected)
#define ASSERT_IMAGES_EQ(image, expected) ASSERT_PRED_FORMAT2(lambentImagesEqual, image, expected)
#define EXPECT_IMAGES_NEAR(image, expected, tolerance)                                             \
  EXPECT_PRED_FORMAT3(lambentImagesNear, image, expected, tolerance)
#define ASSERT_IMAGES_NEAR(image, expected, tolerance)                                             \
  ASSERT_PRED_FORMAT3(lambentImagesNear, image, expected, tolerance)

#endif
