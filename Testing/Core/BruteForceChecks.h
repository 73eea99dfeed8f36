// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what the tests of random scenes share: larger scenes, attributes, comparisons
 */
#ifndef BruteForceChecks_h
#define BruteForceChecks_h

#include "FilmPicture.h"
#include "InstructionSets.h"
#include "LightModel.h"
#include "SurfacePoints.h"

#include <string>
#include <vector>

inline std::string describe(unsigned int seed, const RandomScene& random)
{
  return "seed " + std::to_string(seed) + ": " + random.name + ", " + std::to_string(random.width) +
    " x " + std::to_string(random.height);
}

/// The scene of a seed, larger than a few tiles, and no multiple of their size.
inline RandomScene makeLargerScene(unsigned int seed)
{
  RandomScene random = makeRandomScene(seed);
  random.width = 131;
  random.height = 67;
  return random;
}

/// Gives all surfaces an attribute of points and one of cells. It must outlive the scene.
class NumberedAttributes
{
public:
  explicit NumberedAttributes(lambent::Scene& scene)
  {
    using lambent::AttributeType;
    for (lambent::Surface& surface : scene.surfaces)
    {
      std::vector<double> numbers;
      for (std::size_t k = 0; k < surface.points.size + surface.primitiveCount() + 1; ++k)
      {
        numbers.push_back(static_cast<double>(7 * k % 1001) - 0.25);
      }
      this->Values.push_back(std::move(numbers));
      const double* const memory = this->Values.back().data();
      surface.attributes = { { memory, AttributeType::Double, 1, false },
        { memory, AttributeType::Double, 1, true } };
    }
  }

  /// A pass of each content, and both attributes.
  static std::vector<lambent::Pass> passes()
  {
    using lambent::PassContent;
    return { { PassContent::Depth, 1, true, nullptr, 0 },
      { PassContent::Normal, 3, false, nullptr, 0 }, { PassContent::Position, 3, true, nullptr, 0 },
      { PassContent::Attribute, 1, true, nullptr, 0 },
      { PassContent::Attribute, 1, true, nullptr, 1 } };
  }

private:
  std::vector<std::vector<double>> Values; ///< of each surface
};

/// Renders with every instruction set, and expects this picture.
inline void expectOnAllTargets(const RandomScene& random, const FilmRequest& request,
  const FilmPicture& expected, const std::string& what,
  const lambent::Settings& settings = lambent::Settings(),
  const lambent::Parallel& parallel = lambent::Parallel())
{
  onAllTargets(
    [&]()
    {
      EXPECT_TRUE(makePicture(random, request, whole(random), settings, parallel) == expected)
        << what;
    });
}

/// Expects a pixel to show this primitive, with the colour of the light model; or nothing.
inline void expectPixel(const FilmPicture& picture, int pixel, std::uint32_t primitive,
  const lambent::SurfacePoints& points, const lambent::LightModel& light, double x, double y,
  const std::string& what)
{
  ASSERT_EQ(picture.primitives[pixel], primitive) << what;
  if (primitive != lambent::noPrimitive)
  {
    const lambent::Vec3 expected = light.color(points.at(primitive, x, y));
    for (int channel = 0; channel < 3; ++channel)
    {
      ASSERT_EQ(picture.floats[3 * pixel + channel], lambent::toFloat(expected[channel]))
        << what << ", pixel " << pixel;
    }
  }
}

#endif
