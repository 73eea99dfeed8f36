// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The pixels that a background image may hold.
#include "FilmPicture.h"
#include "RandomNumbers.h"

#include <limits>

using namespace lambent;

namespace
{
FilmRequest withSamples(int samples)
{
  FilmRequest request;
  request.samples = samples;
  return request;
}
}

TEST(BackgroundPixels, OfOtherTypesEqualBruteForce)
{
  RandomScene random = makeSmallScene(3);
  std::vector<double> values;
  RandomNumbers numbers(10);
  for (int k = 0; k < 4 * 6 * 5; ++k)
  {
    values.push_back(numbers.within(0.0, 1.0));
  }
  random.scene.backgroundImage = { { values.data(), AttributeType::Double, 4, false }, 6, 5 };
  const FilmRequest request = withSamples(2);
  EXPECT_TRUE(
    makePicture(random, request, whole(random), Settings()) == makeByBruteForce(random, request));
}

// Formats with alpha may store anything as the colour of a transparent pixel.
TEST(BackgroundPixels, HaveNoColorIfTransparent)
{
  RandomScene empty;
  empty.width = 9;
  empty.height = 6;
  empty.scene.background = { 0.25, 0.5, 0.75 };
  empty.scene.backgroundTop = { 1.0, 0.0, 0.125 };
  for (const int samples : { 1, 2 })
  {
    const FilmRequest request = withSamples(samples);
    empty.scene.backgroundImage = {};
    const FilmPicture gradient = makePicture(empty, request, whole(empty), Settings());
    for (const float value :
      { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1.0f })
    {
      const std::vector<float> grey{ value, 0.0f, value, -0.0f },
        colors{ value, value, 0.5f, 0.0f, 0.5f, value, value, 0.0f };
      for (const int components : { 2, 4 })
      {
        empty.scene.backgroundImage = { { components == 2 ? grey.data() : colors.data(),
                                          AttributeType::Float, components, false },
          2, 1 };
        EXPECT_TRUE(makePicture(empty, request, whole(empty), Settings()) == gradient) << value;
        EXPECT_TRUE(makeByBruteForce(empty, request) == gradient) << value;
      }
    }
  }
}
