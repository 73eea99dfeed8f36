// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The assertions pass and fail as they should, with the comparison's message.

#include "ComparedImages.h"
#include "LambentImageAssertions.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace
{

// Static functions, since EXPECT_FATAL_FAILURE runs its statement in a separate function.
vtkImageData* plain()
{
  static const auto image = grey(7, 5);
  return image;
}

vtkImageData* changed()
{
  static const auto image = grey(7, 5, { { 5, 1, 0, 103 } });
  return image;
}

TEST(ImageAssertions, Pass)
{
  EXPECT_IMAGES_EQ(plain(), grey(7, 5));
  ASSERT_IMAGES_EQ(plain(), plain());
  EXPECT_IMAGES_NEAR(changed(), plain(), 3);
  ASSERT_IMAGES_NEAR(changed(), plain(), 3.0);
  vtkNew<vtkImageData> owned;
  owned->DeepCopy(plain());
  EXPECT_IMAGES_EQ(owned, plain());
}

TEST(ImageAssertions, FailWithTheMessage)
{
  EXPECT_NONFATAL_FAILURE(EXPECT_IMAGES_EQ(changed(), plain()),
    "changed() is not plain(): 1 of 35 pixels differ, by at most 3 of 255; the first is (5, 1)");
  EXPECT_FATAL_FAILURE(ASSERT_IMAGES_EQ(changed(), plain()), "1 of 35 pixels differ");
  EXPECT_NONFATAL_FAILURE(EXPECT_IMAGES_NEAR(changed(), plain(), 2.5), "tolerance of 2.5");
  EXPECT_FATAL_FAILURE(ASSERT_IMAGES_NEAR(changed(), plain(), 2.5), "tolerance of 2.5");
  EXPECT_NONFATAL_FAILURE(EXPECT_IMAGES_EQ(plain(), grey(5, 7)), "but the baseline is 5 x 7");
}

TEST(ImageAssertions, FailWithoutAnImage)
{
  vtkImageData* nothing = nullptr;
  EXPECT_NONFATAL_FAILURE(EXPECT_IMAGES_EQ(nothing, plain()), "nothing is nullptr");
  EXPECT_NONFATAL_FAILURE(EXPECT_IMAGES_EQ(nothing, nothing), "nothing is nullptr");
  EXPECT_NONFATAL_FAILURE(EXPECT_IMAGES_NEAR(plain(), plain(), -1), "negative");
}

} // namespace
