// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief pictures with alpha, bytes, triangles and passes, compared bit by bit
 */
#ifndef FilmPicture_h
#define FilmPicture_h

#include "RandomScenes.h"
#include "Render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

/// The contents of a picture.
struct FilmRequest
{
  int samples = 1;
  bool hasAlpha = false;
  bool isBytes = false;
  std::vector<lambent::Pass> passes;
};

struct FilmPicture
{
  int channels = 3;
  std::vector<unsigned char> bytes; ///< empty if the colours are floats
  std::vector<float> floats;        ///< empty if the colours are bytes
  std::vector<std::uint32_t> primitives;
  std::vector<std::vector<unsigned char>> passes; ///< the memory of each

  bool operator==(const FilmPicture& other) const
  {
    return this->bytes == other.bytes && this->floats.size() == other.floats.size() &&
      std::equal(reinterpret_cast<const unsigned char*>(this->floats.data()),
        reinterpret_cast<const unsigned char*>(this->floats.data() + this->floats.size()),
        reinterpret_cast<const unsigned char*>(other.floats.data())) &&
      this->primitives == other.primitives && this->passes == other.passes;
  }

  /// A component of a pass of this form.
  double value(const lambent::Pass& form, std::size_t pass, std::size_t pixel, int component) const
  {
    const std::size_t k = pixel * static_cast<std::size_t>(form.components) + component;
    double wide;
    float narrow;
    const unsigned char* const data = this->passes[pass].data();
    form.isDouble ? std::memcpy(&wide, data + k * sizeof(wide), sizeof(wide))
                  : std::memcpy(&narrow, data + k * sizeof(narrow), sizeof(narrow));
    return form.isDouble ? wide : static_cast<double>(narrow);
  }
};

inline std::size_t bytesPerPixel(const lambent::Pass& pass)
{
  return static_cast<std::size_t>(pass.components) * (pass.isDouble ? 8 : 4);
}

inline FilmPicture makePicture(const RandomScene& random, const FilmRequest& request,
  const lambent::Window& part, const lambent::Settings& settings,
  const lambent::Parallel& parallel = lambent::Parallel())
{
  const std::size_t pixels = static_cast<std::size_t>(part.width()) * part.height();
  lambent::Image image;
  image.width = random.width;
  image.height = random.height;
  image.part = part;
  image.samples = request.samples;
  image.hasAlpha = request.hasAlpha;
  image.passes.assign(request.passes.begin(), request.passes.end());
  FilmPicture picture;
  picture.channels = image.channels();
  picture.primitives.assign(pixels, 0xABABABABu); // no valid number
  image.primitives = picture.primitives.data();
  if (request.isBytes)
  {
    picture.bytes.assign(picture.channels * pixels, 0xAB);
    image.bytes = picture.bytes.data();
  }
  else
  {
    picture.floats.assign(picture.channels * pixels, -1.0f);
    image.floats = picture.floats.data();
  }
  for (const lambent::Pass& pass : request.passes)
  {
    picture.passes.emplace_back(pixels * bytesPerPixel(pass), static_cast<unsigned char>(0xAB));
  }
  for (std::size_t k = 0; k < picture.passes.size(); ++k)
  {
    image.passes[k].data = picture.passes[k].data();
  }
  EXPECT_EQ(
    render(random.scene, image, parallel, nullptr, settings).outcome, lambent::Outcome::Done);
  return picture;
}

inline lambent::Window whole(const RandomScene& random)
{
  return { 0, random.width, 0, random.height };
}

inline FilmPicture makeByBruteForce(const RandomScene& random, const FilmRequest& request)
{
  return makePicture(random, request, whole(random),
    lambent::Settings::bruteForce(
      { 0, random.width * request.samples, 0, random.height * request.samples }));
}

/// The scene of a seed, small enough for brute force with many samples.
inline RandomScene makeSmallScene(unsigned int seed)
{
  RandomScene random = makeRandomScene(seed);
  random.width = 1 + static_cast<int>(seed % 23);
  random.height = 1 + static_cast<int>(seed % 17);
  return random;
}

/// Cuts the part in a window out of a picture with this width.
inline FilmPicture cut(
  const FilmPicture& picture, const FilmRequest& request, int width, const lambent::Window& part)
{
  FilmPicture result;
  result.channels = picture.channels;
  result.passes.resize(picture.passes.size());
  const auto append = [](auto& to, const auto& from, std::size_t begin, std::size_t count)
  {
    const auto first = from.begin() + static_cast<std::ptrdiff_t>(begin);
    to.insert(to.end(), first, first + static_cast<std::ptrdiff_t>(count));
  };
  const auto columns = static_cast<std::size_t>(part.width());
  for (int j = part.j0; j < part.j1; ++j)
  {
    const std::size_t first = static_cast<std::size_t>(j) * width + part.i0;
    const std::size_t channels = picture.channels;
    append(result.primitives, picture.primitives, first, columns);
    if (request.isBytes)
    {
      append(result.bytes, picture.bytes, channels * first, channels * columns);
    }
    else
    {
      append(result.floats, picture.floats, channels * first, channels * columns);
    }
    for (std::size_t k = 0; k < picture.passes.size(); ++k)
    {
      const std::size_t size = bytesPerPixel(request.passes[k]);
      append(result.passes[k], picture.passes[k], size * first, size * columns);
    }
  }
  return result;
}

/// Renders a part alone, and cuts it out of the whole picture.
inline void expectPartEqualToTheWhole(
  const RandomScene& random, const FilmRequest& request, unsigned int seed)
{
  const lambent::Window part{ random.width / 3, random.width, random.height / 2, random.height };
  EXPECT_TRUE(makePicture(random, request, part, lambent::Settings()) ==
    cut(makePicture(random, request, whole(random), lambent::Settings()), request, random.width,
      part))
    << "seed " << seed;
}

#endif
