// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// A background image is stretched to the picture and interpolated between the centres of its
// pixels. An image of the picture's size is reproduced exactly.
#include "FilmPicture.h"
#include "InstructionSets.h"
#include "RandomNumbers.h"
#include "ThreadedParallel.h"

#include <limits>

using namespace lambent;

namespace
{
/// An image of bytes or floats, and its memory.
struct Pixels
{
  int width, height, components;
  bool isBytes;
  std::vector<unsigned char> bytes;
  std::vector<float> floats;

  Pixels(RandomNumbers& random, int w, int h, int c, bool asBytes)
    : width(w)
    , height(h)
    , components(c)
    , isBytes(asBytes)
  {
    for (int k = 0; k < w * h * c; ++k)
    {
      this->bytes.push_back(static_cast<unsigned char>(random.below(256)));
      this->floats.push_back(static_cast<float>(random.within(-0.25, 1.5)));
    }
  }

  void putBehind(Scene& scene) const
  {
    const void* const data = this->isBytes ? static_cast<const void*>(this->bytes.data())
                                           : static_cast<const void*>(this->floats.data());
    const AttributeType type = this->isBytes ? AttributeType::UInt8 : AttributeType::Float;
    scene.backgroundImage = { { data, type, this->components, false }, this->width, this->height };
  }

  double at(int i, int j, int component) const
  {
    const int k = (j * this->width + i) * this->components + component;
    return this->isBytes ? this->bytes[k] / 255.0 : static_cast<double>(this->floats[k]);
  }

  /// A pixel composited over a colour.
  Vec3 over(int i, int j, const Vec3& base) const
  {
    const bool isColored = this->components > 2;
    const Vec3 color(
      this->at(i, j, 0), this->at(i, j, isColored ? 1 : 0), this->at(i, j, isColored ? 2 : 0));
    if (this->components == 1 || this->components == 3)
    {
      return color;
    }
    const double alpha = this->at(i, j, this->components - 1);
    return color * alpha + base * (1.0 - alpha);
  }
};

/// A place between two pixels, and the weight of the second.
struct Between
{
  int first, second;
  double share;

  Between(double place, int count)
  {
    const double x = std::min(std::max(place, 0.0), count - 1.0);
    this->first = static_cast<int>(x);
    this->second = std::min(this->first + 1, count - 1);
    this->share = x - this->first;
  }
};

Vec3 mixed(const Vec3& a, const Vec3& b, double share)
{
  return share == 0.0 ? a : a + (b - a) * share;
}

/// The background of sample (i, j) of a picture of W x H samples.
Vec3 expectedSample(const Pixels& image, const Scene& scene, int i, int j, int W, int H)
{
  const Vec3 base = scene.background + (scene.backgroundTop - scene.background) * ((j + 0.5) / H);
  const Between x((i + 0.5) * image.width / W - 0.5, image.width);
  const Between y((j + 0.5) * image.height / H - 0.5, image.height);
  const auto inRow = [&](int row)
  { return mixed(image.over(x.first, row, base), image.over(x.second, row, base), x.share); };
  return mixed(inRow(y.first), inRow(y.second), y.share);
}

FilmRequest withSamples(int samples, bool isBytes)
{
  FilmRequest request;
  request.samples = samples;
  request.isBytes = isBytes;
  return request;
}

/// A random scene in front of a random image.
struct Subject
{
  RandomScene random;
  RandomNumbers numbers;
  Pixels image;
  FilmRequest request;

  Subject(unsigned int seed, int samples)
    : random(makeSmallScene(seed))
    , numbers(seed)
    , image(numbers, 1 + numbers.below(40), 1 + numbers.below(30), 1 + static_cast<int>(seed % 4),
        seed / 4 % 2 == 0)
    , request(withSamples(samples, seed / 8 % 2 == 0))
  {
    this->image.putBehind(this->random.scene);
  }
};
}

// The definition, written as plainly as possible.
TEST(BackgroundImage, IsInterpolatedBetweenTheCentresOfItsPixels)
{
  std::size_t seen = 0;
  for (unsigned int seed = 0; seed < 96 && !HasFailure(); ++seed)
  {
    const int n = 1 + static_cast<int>(seed % 3);
    const Subject subject(seed, n);
    const RandomScene& random = subject.random;
    RandomScene larger = makeSmallScene(seed);
    larger.width *= n;
    larger.height *= n;
    const std::vector<std::uint32_t> triangles = makeByBruteForce(larger, FilmRequest()).primitives;
    const FilmPicture picture = makeByBruteForce(random, subject.request);
    for (int pixel = 0; pixel < random.width * random.height; ++pixel)
    {
      Vec3 sum;
      bool isBackground = true;
      for (int k = 0; k < n * n; ++k)
      {
        const int i = n * (pixel % random.width) + k % n, j = n * (pixel / random.width) + k / n;
        isBackground &= triangles[static_cast<std::size_t>(j) * larger.width + i] == noPrimitive;
        const Vec3 sample =
          expectedSample(subject.image, random.scene, i, j, larger.width, larger.height);
        sum = k == 0 ? sample : sum + sample;
      }
      seen += isBackground;
      for (int channel = 0; isBackground && channel < 3; ++channel)
      {
        const double expected = sum[channel] / static_cast<double>(n * n);
        const int k = 3 * pixel + channel;
        EXPECT_EQ(subject.request.isBytes ? picture.bytes[k] : picture.floats[k],
          subject.request.isBytes ? toByte(expected) : static_cast<float>(expected))
          << "seed " << seed << ", pixel " << pixel;
      }
    }
  }
  EXPECT_GT(seen, 3000u);
}

TEST(BackgroundImage, EqualsBruteForceInEveryInstructionSet)
{
  for (unsigned int seed = 100; seed < 164 && !HasFailure(); ++seed)
  {
    const Subject subject(seed, 1 + static_cast<int>(seed / 4 % 16));
    const FilmPicture expected = makeByBruteForce(subject.random, subject.request);
    onAllTargets(
      [&]()
      {
        Settings settings;
        settings.tileShift = static_cast<int>(seed % 7);
        EXPECT_TRUE(
          makePicture(subject.random, subject.request, whole(subject.random), settings) == expected)
          << "seed " << seed;
        EXPECT_TRUE(makePicture(subject.random, subject.request, whole(subject.random), Settings(),
                      ThreadedParallel(3)) == expected)
          << "seed " << seed << ", three workers";
      });
  }
}

TEST(BackgroundImage, PartsEqualThoseOfTheWhole)
{
  for (unsigned int seed = 200; seed < 240; ++seed)
  {
    const Subject subject(seed, 1 + static_cast<int>(seed % 4));
    expectPartEqualToTheWhole(subject.random, subject.request, seed);
  }
}

TEST(BackgroundImage, IsReproducedExactlyAtThePicturesSize)
{
  RandomNumbers numbers(7);
  for (int k = 0; k < 60; ++k)
  {
    RandomScene empty;
    empty.width = 1 + numbers.below(70);
    empty.height = 1 + numbers.below(50);
    const int components = k % 2 == 0 ? 1 : 3;
    Pixels image(numbers, empty.width, empty.height, components, k % 4 < 2);
    // Also numbers that differ much from their neighbours, and NaN.
    for (const float value : { std::numeric_limits<float>::infinity(), 1e38f, -1e38f, 1e-38f, -0.0f,
           std::numeric_limits<float>::quiet_NaN() })
    {
      image.floats[numbers.below(static_cast<int>(image.floats.size()))] = value;
    }
    image.putBehind(empty.scene);
    for (const bool byBruteForce : { false, true })
    {
      const FilmRequest request = withSamples(1, image.isBytes);
      const FilmPicture picture = byBruteForce
        ? makeByBruteForce(empty, request)
        : makePicture(empty, request, whole(empty), Settings());
      for (int channel = 0; channel < 3 * empty.width * empty.height; ++channel)
      {
        const int from = components == 1 ? channel / 3 : channel;
        if (image.isBytes)
        {
          EXPECT_EQ(picture.bytes[channel], image.bytes[from]);
          continue;
        }
        EXPECT_EQ(std::memcmp(&picture.floats[channel], &image.floats[from], sizeof(float)), 0)
          << picture.floats[channel] << " instead of " << image.floats[from];
      }
    }
  }
}

// Rows of samples read only the pixels that they need.
TEST(BackgroundImage, LargerThanThePictureEqualsBruteForce)
{
  RandomNumbers numbers(9);
  for (int k = 0; k < 16; ++k)
  {
    RandomScene random = makeSmallScene(k);
    random.width = 70;
    random.height = 3;
    const Pixels image(numbers, 71 << k % 4, 9, 1 + k / 4, k % 2 == 0);
    image.putBehind(random.scene);
    const FilmRequest request = withSamples(1 + k % 3, false);
    EXPECT_TRUE(
      makePicture(random, request, whole(random), Settings()) == makeByBruteForce(random, request))
      << image.width << " x " << image.height;
  }
}

// Opaque pixels hide the gradient; transparent pixels show only the gradient.
TEST(BackgroundImage, IsCompositedOverTheGradient)
{
  RandomNumbers numbers(8);
  RandomScene empty;
  empty.width = 9;
  empty.height = 6;
  empty.scene.background = { 0.25, 0.5, 0.75 };
  empty.scene.backgroundTop = { 1.0, 0.0, 0.125 };
  const FilmRequest request = withSamples(2, false);
  const FilmPicture gradient = makePicture(empty, request, whole(empty), Settings());
  for (const int components : { 2, 4 })
  {
    for (const bool isOpaque : { false, true })
    {
      Pixels image(numbers, 4, 5, components, true);
      for (std::size_t k = components - 1; k < image.bytes.size(); k += components)
      {
        image.bytes[k] = isOpaque ? 255 : 0;
      }
      image.putBehind(empty.scene);
      const FilmPicture picture = makePicture(empty, request, whole(empty), Settings());
      if (!isOpaque)
      {
        EXPECT_TRUE(picture == gradient);
        continue;
      }
      Pixels colors(numbers, 4, 5, components - 1, true);
      for (std::size_t k = 0; k < colors.bytes.size(); ++k)
      {
        colors.bytes[k] = image.bytes[k / (components - 1) * components + k % (components - 1)];
      }
      colors.putBehind(empty.scene);
      EXPECT_TRUE(picture == makePicture(empty, request, whole(empty), Settings()));
    }
  }
}

// A single pixel fills the picture. Beyond the outermost centres nothing is extrapolated.
TEST(BackgroundImage, IsConstantBeyondItsOutermostCentres)
{
  RandomScene empty;
  empty.width = 8;
  empty.height = 2;
  const std::vector<float> one{ 0.3f }, two{ 0.0f, 1.0f };
  empty.scene.backgroundImage = { { one.data(), AttributeType::Float, 1, false }, 1, 1 };
  const FilmRequest request = withSamples(1, false);
  EXPECT_EQ(makePicture(empty, request, whole(empty), Settings()).floats,
    std::vector<float>(3u * 8 * 2, 0.3f));
  empty.scene.backgroundImage = { { two.data(), AttributeType::Float, 1, false }, 2, 1 };
  const FilmPicture ramp = makePicture(empty, request, whole(empty), Settings());
  const float expected[8] = { 0.0f, 0.0f, 0.125f, 0.375f, 0.625f, 0.875f, 1.0f, 1.0f };
  for (int k = 0; k < 3 * 8 * 2; ++k)
  {
    EXPECT_EQ(ramp.floats[k], expected[k / 3 % 8]) << k;
  }
}
