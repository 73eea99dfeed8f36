// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The results of comparing pictures with known differences. A single bit must be enough to fail.

#include "ComparedImages.h"

#include "../Rendering/Messages.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void expectExtent(vtkLambentImageComparison* comparison, int x0, int x1, int y0, int y1)
{
  int extent[4];
  comparison->GetChangedExtent(extent);
  EXPECT_EQ(extent[0], x0);
  EXPECT_EQ(extent[1], x1);
  EXPECT_EQ(extent[2], y0);
  EXPECT_EQ(extent[3], y1);
}

TEST(ImageComparison, NothingHasPassedBeforeUpdate)
{
  vtkNew<vtkLambentImageComparison> comparison;
  EXPECT_FALSE(comparison->GetPassed());
  EXPECT_NE(std::string(comparison->GetMessage()).find("Update()"), std::string::npos);
}

TEST(ImageComparison, SamePicturesPass)
{
  const auto c = compare(grey(7, 5), grey(7, 5));
  EXPECT_TRUE(c->GetPassed());
  EXPECT_EQ(c->GetMaximumDifference(), 0.0);
  EXPECT_EQ(c->GetRootMeanSquare(), 0.0);
  EXPECT_EQ(c->GetNumberOfChangedPixels(), 0);
  expectExtent(c, 0, -1, 0, -1);
  EXPECT_STREQ(c->GetMessage(), "all of 35 pixels are the same");
}

TEST(ImageComparison, EachSingleChannelCounts)
{
  for (int y = 0; y < 3; ++y)
  {
    for (int x = 0; x < 4; ++x)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        const auto c = compare(grey(4, 3, { { x, y, channel, 101 } }), grey(4, 3));
        EXPECT_FALSE(c->GetPassed());
        EXPECT_EQ(c->GetNumberOfChangedPixels(), 1);
        EXPECT_EQ(c->GetMaximumDifference(), 1.0);
        EXPECT_EQ(c->GetRootMeanSquare(), std::sqrt(1.0 / 36.0));
        expectExtent(c, x, x, y, y);
        EXPECT_EQ(c->GetMessage(),
          "1 of 12 pixels differ, by at most 1 of 255; the first is (" + std::to_string(x) + ", " +
            std::to_string(y) + ")");
      }
    }
  }
}

TEST(ImageComparison, SeveralPixelsAreCountedAndFramed)
{
  // Two channels of (5, 1) differ by 3 and 4; one of (2, 2) by 10, of (3, 2) by 2, of (4, 3) by 1.
  const auto c = compare(
    grey(7, 5,
      { { 5, 1, 0, 103 }, { 5, 1, 2, 96 }, { 2, 2, 1, 90 }, { 3, 2, 1, 102 }, { 4, 3, 0, 101 } }),
    grey(7, 5));
  EXPECT_EQ(c->GetNumberOfChangedPixels(), 4);
  EXPECT_EQ(c->GetMaximumDifference(), 10.0);
  EXPECT_EQ(c->GetRootMeanSquare(), std::sqrt((9.0 + 16.0 + 100.0 + 4.0 + 1.0) / 105.0));
  expectExtent(c, 2, 5, 1, 3);
  EXPECT_STREQ(c->GetMessage(), "4 of 35 pixels differ, by at most 10 of 255; the first is (5, 1)");
}

TEST(ImageComparison, PictureAndBaselineMayBeSwapped)
{
  const auto a = grey(3, 3, { { 1, 1, 1, 250 } }), b = grey(3, 3);
  EXPECT_EQ(compare(a, b)->GetMaximumDifference(), 150.0);
  EXPECT_EQ(compare(b, a)->GetMaximumDifference(), 150.0);
}

TEST(ImageComparison, ToleranceIsTheLargestDifferenceThatPasses)
{
  const auto a = grey(3, 3, { { 1, 1, 1, 105 } });
  EXPECT_TRUE(compare(a, grey(3, 3), 5.0)->GetPassed());
  EXPECT_FALSE(compare(a, grey(3, 3), 4.999)->GetPassed());
  EXPECT_STREQ(compare(a, grey(3, 3), 5.0)->GetMessage(),
    "1 of 9 pixels differ, by at most 5 of 255; the first is (1, 1); the tolerance of 5 allows it");
  EXPECT_STREQ(compare(a, grey(3, 3), 2.0)->GetMessage(),
    "1 of 9 pixels differ, by at most 5 of 255; the first is (1, 1); the tolerance of 2 is "
    "exceeded");
}

TEST(ImageComparison, RootMeanSquareIsComparedWithTheTolerance)
{
  const auto a = grey(2, 2, { { 1, 1, 1, 106 } }), b = grey(2, 2); // sqrt(36 / 12)
  const int metric = vtkLambentImageComparison::ROOT_MEAN_SQUARE;
  EXPECT_TRUE(compare(a, b, 1.7321, metric)->GetPassed());
  EXPECT_FALSE(compare(a, b, 1.7320, metric)->GetPassed());
  EXPECT_FALSE(compare(a, b, 0.0, metric)->GetPassed());
  EXPECT_TRUE(compare(b, b, 0.0, metric)->GetPassed());
  EXPECT_STREQ(compare(a, b, 1.0, metric)->GetMessage(),
    "1 of 4 pixels differ, by at most 6 of 255; the first is (1, 1); the root mean square is "
    "1.73205; the tolerance of 1 is exceeded");
}

TEST(ImageComparison, DifferentSizesFailAndAreNamed)
{
  const auto c = compare(grey(7, 5), grey(5, 7), 255.0);
  EXPECT_FALSE(c->GetPassed());
  EXPECT_STREQ(c->GetMessage(),
    "the picture is 7 x 5, 3 components of unsigned char, but the "
    "baseline is 5 x 7, 3 components of unsigned char");
  EXPECT_TRUE(std::isnan(c->GetMaximumDifference()));
  EXPECT_EQ(c->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ImageComparison, OtherComponentsAndTypesFail)
{
  const auto rgb = grey(2, 2);
  EXPECT_STREQ(compare(rgb, values<unsigned char>(2, 2, 1))->GetMessage(),
    "the picture is 2 x 2, 3 components of unsigned char, but the baseline is 2 x 2, 1 component "
    "of unsigned char");
  EXPECT_FALSE(compare(rgb, values<unsigned char>(2, 2, 4), 255.0)->GetPassed());
  EXPECT_FALSE(compare(rgb, values<float>(2, 2, 3), 255.0)->GetPassed());
}

TEST(ImageComparison, OriginSpacingAndExtentDoNotMatter)
{
  const auto a = grey(4, 3, { { 2, 1, 0, 7 } }), b = grey(4, 3);
  b->SetExtent(10, 13, -5, -3, 2, 2);
  b->SetOrigin(1, 2, 3);
  b->SetSpacing(0.5, 0.5, 0.5);
  const auto c = compare(a, b);
  EXPECT_EQ(c->GetNumberOfChangedPixels(), 1);
  expectExtent(c, 2, 2, 1, 1);
}

TEST(ImageComparison, NaNEqualsNaN)
{
  const auto a = values<float>(3, 1, 1, { 1.0, nan, infinity });
  EXPECT_TRUE(compare(a, values<float>(3, 1, 1, { 1.0, nan, infinity }))->GetPassed());
  const auto c = compare(a, values<float>(3, 1, 1, { 1.0, 2.0, infinity }), 1e9);
  EXPECT_FALSE(c->GetPassed());
  EXPECT_EQ(c->GetMaximumDifference(), infinity);
  EXPECT_EQ(c->GetRootMeanSquare(), infinity);
  EXPECT_EQ(c->GetNumberOfChangedPixels(), 1);
  EXPECT_FALSE(compare(a, values<float>(3, 1, 1, { 1.0, nan, -infinity }), 1e9)->GetPassed());
}

TEST(ImageComparison, OneUlpOfAFloatFails)
{
  const auto c = compare(
    values<float>(1, 1, 1, { std::nextafter(0.1f, 1.0f) }), values<float>(1, 1, 1, { 0.1f }));
  EXPECT_FALSE(c->GetPassed());
  EXPECT_EQ(c->GetMaximumDifference(),
    static_cast<double>(std::nextafter(0.1f, 1.0f)) - static_cast<double>(0.1f));
}

TEST(ImageComparison, IntegersOfTheWholeRange)
{
  const double low = std::numeric_limits<int>::min(), high = std::numeric_limits<int>::max();
  const auto c = compare(values<int>(1, 1, 1, { low }), values<int>(1, 1, 1, { high }));
  EXPECT_EQ(c->GetMaximumDifference(), 4294967295.0);
  EXPECT_EQ(c->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0), high); // the type's maximum
}

TEST(ImageComparison, OutputIsTheAbsoluteDifference)
{
  const auto c = compare(grey(4, 3, { { 2, 1, 0, 90 }, { 3, 2, 2, 107 } }), grey(4, 3));
  vtkImageData* output = c->GetOutput();
  EXPECT_EQ(output->GetScalarType(), VTK_UNSIGNED_CHAR);
  for (int y = 0; y < 3; ++y)
  {
    for (int x = 0; x < 4; ++x)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        const int expected = x == 2 && y == 1 && channel == 0 ? 10
          : x == 3 && y == 2 && channel == 2                  ? 7
                                                              : 0;
        EXPECT_EQ(output->GetScalarComponentAsDouble(x, y, 0, channel), expected);
      }
    }
  }
}

TEST(ImageComparison, HighlightShowsTheSmallestDifference)
{
  const auto a = values<float>(4, 1, 4,
    { 0, 0, 0, 0, /**/ 1e-6, 0, 0, 0, /**/ 0, -0.5, 0, 0, //
      0, 0, 0, 1 });
  vtkNew<vtkLambentImageComparison> c;
  c->SetPictureData(a);
  c->SetBaselineData(values<float>(4, 1, 4));
  c->HighlightOn();
  c->Update();
  vtkImageData* output = c->GetOutput();
  ASSERT_EQ(output->GetScalarType(), VTK_UNSIGNED_CHAR);
  ASSERT_EQ(output->GetNumberOfScalarComponents(), 3);
  const int expected[4][3] = { { 0, 0, 0 }, { 55, 0, 0 }, { 0, 155, 0 }, { 255, 255, 255 } };
  for (int x = 0; x < 4; ++x)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      EXPECT_EQ(output->GetScalarComponentAsDouble(x, 0, 0, channel), expected[x][channel]) << x;
    }
  }
}

// PrintSelf() names every setting and result, with its value.
TEST(ImageComparison, PrintSelfIsComplete)
{
  const auto printed = [](vtkLambentImageComparison* c)
  {
    std::ostringstream text;
    c->Print(text);
    return text.str();
  };
  const auto c = compare(grey(4, 3, { { 2, 1, 0, 94 } }), grey(4, 3), 7.5);
  c->HighlightOn();
  for (const char* part : { "Metric: MaximumDifference\n", "Tolerance: 7.5\n", "Highlight: On\n",
         "Passed: Yes\n", "MaximumDifference: 6\n", "RootMeanSquare: 1\n",
         "StructuralSimilarity: nan\n", "NumberOfChangedPixels: 1\n",
         "ChangedExtent: (2, 2, 1, 1)\n", "Message: 1 of 12 pixels differ" })
  {
    EXPECT_NE(printed(c).find(part), std::string::npos) << part << " in\n" << printed(c);
  }
  c->SetMetricToRootMeanSquare();
  EXPECT_NE(printed(c).find("Metric: RootMeanSquare\n"), std::string::npos);
  c->SetMetricToStructuralSimilarity();
  EXPECT_NE(printed(c).find("Metric: StructuralSimilarity\n"), std::string::npos);
  c->SetMetricToMaximumDifference();
  EXPECT_STREQ(c->GetMetricAsString(), "MaximumDifference");
}

TEST(ImageComparison, ResultsDoNotDependOnThreads)
{
  std::vector<double> numbers(301 * 97);
  for (std::size_t k = 0; k < numbers.size(); ++k)
  {
    numbers[k] = std::sin(static_cast<double>(k)) * std::exp(static_cast<double>(k % 40));
  }
  const auto a = values<double>(301, 97, 1, numbers), b = values<double>(301, 97, 1);
  vtkSMPTools::Initialize(1);
  const double one = compare(a, b)->GetRootMeanSquare();
  vtkSMPTools::Initialize(2);
  EXPECT_EQ(compare(a, b)->GetRootMeanSquare(), one);
}

TEST(ImageComparison, StructuralSimilarity)
{
  const int metric = vtkLambentImageComparison::STRUCTURAL_SIMILARITY;
  vtkNew<vtkLambentImageComparison> comparison;
  if (!vtkLambentImageComparison::HasStructuralSimilarity())
  {
    const Messages messages(comparison);
    compareIn(comparison, grey(9, 9), grey(9, 9), 0.5, metric);
    EXPECT_FALSE(comparison->GetPassed());
    expectMessage(messages.errors(), { "vtkImageSSIM", "Choose another metric" });
    return;
  }
  compareIn(comparison, grey(9, 9), grey(9, 9), 0.0, metric);
  EXPECT_TRUE(comparison->GetPassed());
  EXPECT_NEAR(comparison->GetStructuralSimilarity(), 1.0, 1e-12);
  compareIn(comparison, grey(9, 9, { { 4, 4, 1, 255 } }), grey(9, 9), 0.0, metric);
  EXPECT_FALSE(comparison->GetPassed());
  const double lacks = 1.0 - comparison->GetStructuralSimilarity();
  EXPECT_GT(lacks, 0.01);
  EXPECT_LT(lacks, 1.0);
  compareIn(comparison, grey(9, 9, { { 4, 4, 1, 255 } }), grey(9, 9), lacks * 1.01, metric);
  EXPECT_TRUE(comparison->GetPassed());
}

} // namespace
