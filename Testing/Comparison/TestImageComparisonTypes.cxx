// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The comparison accepts numbers of every type, in any memory layout.

#include "ComparedImages.h"

#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

// Differences in several rows and columns.
template <typename T>
void expectNumbers()
{
  const auto a = values<T>(3, 2, 1, { 1, 2, 3, 4, 5, 60 });
  const auto b = values<T>(3, 2, 1, { 1, 2, 3, 7, 5, 20 });
  SCOPED_TRACE(a->GetScalarTypeAsString());
  for (const auto& c : { compare(a, b), compare(b, a) })
  {
    EXPECT_FALSE(c->GetPassed());
    EXPECT_EQ(c->GetNumberOfChangedPixels(), 2);
    EXPECT_EQ(c->GetMaximumDifference(), 40.0);
    EXPECT_EQ(c->GetRootMeanSquare(), std::sqrt((9.0 + 1600.0) / 6.0));
    EXPECT_EQ(c->GetOutput()->GetScalarType(), a->GetScalarType());
    EXPECT_EQ(c->GetOutput()->GetScalarComponentAsDouble(0, 1, 0, 0), 3.0);
    EXPECT_EQ(c->GetOutput()->GetScalarComponentAsDouble(1, 1, 0, 0), 0.0);
    EXPECT_EQ(c->GetOutput()->GetScalarComponentAsDouble(2, 1, 0, 0), 40.0);
  }
  EXPECT_TRUE(compare(a, values<T>(3, 2, 1, { 1, 2, 3, 4, 5, 60 }))->GetPassed());
}

template <typename... T>
void expectNumbersOfEach()
{
  (expectNumbers<T>(), ...);
}

TEST(ImageComparisonTypes, EveryNumberType)
{
  expectNumbersOfEach<char, signed char, unsigned char, short, unsigned short, int, unsigned int,
    long, unsigned long, long long, unsigned long long, float, double>();
}

TEST(ImageComparisonTypes, TheLargestValueIsNamedIfMeaningful)
{
  const auto message = [](const vtkSmartPointer<vtkImageData>& a, vtkImageData* b)
  { return std::string(compare(a, b)->GetMessage()); };
  const std::string differ = "1 of 1 pixels differ, by at most 5";
  const std::string first = "; the first is (0, 0)";
  EXPECT_EQ(message(values<unsigned char>(1, 1, 1, { 5 }), values<unsigned char>(1, 1, 1)),
    differ + " of 255" + first);
  EXPECT_EQ(message(values<unsigned short>(1, 1, 1, { 5 }), values<unsigned short>(1, 1, 1)),
    differ + " of 65535" + first);
  EXPECT_EQ(message(values<float>(1, 1, 1, { 5 }), values<float>(1, 1, 1)), differ + first);
}

// For grey with an alpha channel, the three colours show the larger of the two differences.
TEST(ImageComparisonTypes, HighlightOfGreyAndInfinity)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const auto highlighted = [](int components, const std::vector<double>& list)
  {
    vtkNew<vtkLambentImageComparison> c;
    c->SetPictureData(values<float>(2, 1, components, list));
    c->SetBaselineData(values<float>(2, 1, components));
    c->HighlightOn();
    c->Update();
    std::vector<double> shown;
    for (int k = 0; k < 6; ++k)
    {
      shown.push_back(c->GetOutput()->GetScalarComponentAsDouble(k / 3, 0, 0, k % 3));
    }
    return shown;
  };
  EXPECT_EQ(highlighted(1, { 0.5, 1 }), (std::vector<double>{ 155, 155, 155, 255, 255, 255 }));
  EXPECT_EQ(
    highlighted(2, { 0.25, 0.5, 1, 0 }), (std::vector<double>{ 155, 155, 155, 255, 255, 255 }));
  EXPECT_EQ(
    highlighted(3, { 1, 0, 0, infinity, 0, 0 }), (std::vector<double>{ 55, 0, 0, 255, 0, 0 }));
}

// Arrays that store each channel separately.
TEST(ImageComparisonTypes, MemoryLayoutDoesNotMatter)
{
  const auto apart = [](vtkImageData* image)
  {
    vtkNew<vtkSOADataArrayTemplate<unsigned char>> channels;
    channels->DeepCopy(image->GetPointData()->GetScalars());
    EXPECT_FALSE(channels->HasStandardMemoryLayout());
    auto result = vtkSmartPointer<vtkImageData>::New();
    result->CopyStructure(image);
    result->GetPointData()->SetScalars(channels);
    return result;
  };
  const auto a = grey(4, 3, { { 2, 1, 0, 90 }, { 3, 2, 2, 107 } }), b = grey(4, 3);
  for (const auto& c : { compare(apart(a), b), compare(a, apart(b)), compare(apart(a), apart(b)) })
  {
    EXPECT_EQ(c->GetNumberOfChangedPixels(), 2);
    EXPECT_EQ(c->GetMaximumDifference(), 10.0);
    EXPECT_EQ(c->GetOutput()->GetScalarComponentAsDouble(2, 1, 0, 0), 10.0);
    EXPECT_EQ(c->GetOutput()->GetScalarComponentAsDouble(3, 2, 0, 2), 7.0);
  }
}

} // namespace
