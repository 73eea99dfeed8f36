// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The core: for any scene, any division of the work and any vectors, the picture is that of brute
// force, bit for bit, and the defects of the mesh are the same.
#include "FuzzScene.h"

#include "CameraFrame.h"
#include "Render.h"
#include "ThreadedParallel.h"

#include <string>
#include <vector>

using namespace lambent;

namespace
{
/// The contents of the picture and the background image. Zero bytes mean only colours, as floats.
struct FuzzFilm
{
  int samples;
  bool hasAlpha, isBytes, hasPasses;
  std::vector<Pass> passes;
  int imageWidth = 0, imageHeight = 0;
  std::vector<float> image;
  BackgroundImage behind;

  explicit FuzzFilm(FuzzInput& input)
    : samples(1 + input.choice(4))
  {
    const int kind = input.byte();
    this->hasAlpha = (kind & 1) != 0;
    this->isBytes = (kind & 2) != 0;
    this->hasPasses = (kind & 4) != 0;
    const bool hasDoubles = (kind & 8) != 0;
    const int components = input.choice(5);
    if (this->hasPasses)
    {
      this->passes = { { PassContent::Depth, 1, hasDoubles, nullptr, 0 },
        { PassContent::Normal, 3, hasDoubles, nullptr, 0 },
        { PassContent::Position, 3, !hasDoubles, nullptr, 0 },
        { PassContent::Attribute, attributeComponents, hasDoubles, nullptr, 0 },
        { PassContent::Attribute, attributeComponents, !hasDoubles, nullptr, 1 } };
    }
    if (components > 0)
    {
      this->imageWidth = 1 + input.choice(8);
      this->imageHeight = 1 + input.choice(8);
      for (int k = 0; k < this->imageWidth * this->imageHeight * components; ++k)
      {
        this->image.push_back(
          input.seldom(32) ? input.raw<float>() : static_cast<float>(input.within(-0.5, 1.5)));
      }
      // The bytes of floats are also valid as bytes.
      const AttributeType type = hasDoubles ? AttributeType::UInt8 : AttributeType::Float;
      this->behind = { { this->image.data(), type, components, false }, this->imageWidth,
        this->imageHeight };
    }
  }
};

struct Picture
{
  std::vector<float> floats;
  std::vector<unsigned char> bytes;
  std::vector<std::vector<unsigned char>> passes;
  Report report;
};

std::size_t sizeOf(const Pass& pass)
{
  return static_cast<std::size_t>(pass.components) * (pass.isDouble ? 8 : 4);
}

Picture draw(const FuzzScene& from, const FuzzFilm& film, const Window& part,
  const Settings& settings, const Parallel& parallel, int abortAfter = -1)
{
  Picture picture;
  const std::size_t pixels = static_cast<std::size_t>(part.width()) * part.height();
  Image image;
  image.width = from.width;
  image.height = from.height;
  image.part = part;
  image.samples = film.samples;
  image.hasAlpha = film.hasAlpha;
  image.passes = film.passes;
  if (film.isBytes)
  {
    picture.bytes.assign(image.channels() * pixels, 0xAB);
    image.bytes = picture.bytes.data();
  }
  else
  {
    picture.floats.assign(image.channels() * pixels, -1.0f);
    image.floats = picture.floats.data();
  }
  for (const Pass& pass : film.passes)
  {
    picture.passes.emplace_back(pixels * sizeOf(pass), static_cast<unsigned char>(0xAB));
  }
  for (std::size_t k = 0; k < picture.passes.size(); ++k)
  {
    image.passes[k].data = picture.passes[k].data();
  }
  picture.report = render(
    from.scene, image, parallel, [&abortAfter](double) { return abortAfter-- != 0; }, settings);
  return picture;
}

/// The bits of a NaN may differ, since the contract only covers numbers.
bool areSame(float a, float b)
{
  return std::memcmp(&a, &b, sizeof(float)) == 0 || (std::isnan(a) && std::isnan(b));
}

bool areSame(unsigned char a, unsigned char b)
{
  return a == b;
}

/// Compares a row of a part with that of the whole. `values` is the number of values per pixel.
template <typename Value>
void compareRow(const std::vector<Value>& whole, const std::vector<Value>& picture, int width,
  const Window& part, int j, std::size_t values)
{
  const std::size_t from = values * (static_cast<std::size_t>(j) * width + part.i0);
  const std::size_t to = values * (static_cast<std::size_t>(j - part.j0) * part.width());
  for (std::size_t k = 0; !whole.empty() && k < values * part.width(); ++k)
  {
    require(areSame(picture[to + k], whole[from + k]), "each value equals that of brute force");
  }
}

void compare(const FuzzScene& from, const FuzzFilm& film, const Picture& whole,
  const Picture& picture, const Window& part)
{
  require(picture.report.outcome == whole.report.outcome, "the outcome equals that of brute force");
  const MeshDefects &a = whole.report.defects, &b = picture.report.defects;
  require(a.wrongCorner == b.wrongCorner, "the first wrong corner is the same");
  if (whole.report.outcome == Outcome::BadMesh)
  {
    return;
  }
  require(a.notFinite == b.notFinite && a.firstNotFinite == b.firstNotFinite,
    "the cells that are not finite are the same");
  const std::size_t channels = film.hasAlpha ? 4 : 3;
  for (int j = part.j0; j < part.j1; ++j)
  {
    compareRow(whole.floats, picture.floats, from.width, part, j, channels);
    compareRow(whole.bytes, picture.bytes, from.width, part, j, channels);
    for (std::size_t k = 0; k < film.passes.size(); ++k)
    {
      compareRow(whole.passes[k], picture.passes[k], from.width, part, j, sizeOf(film.passes[k]));
    }
  }
}

Window makePart(FuzzInput& input, int width, int height)
{
  Window part{ 0, width, 0, height };
  if (input.flag())
  {
    part.i0 = input.choice(width);
    part.i1 = part.i0 + 1 + input.choice(width - part.i0);
    part.j0 = input.choice(height);
    part.j1 = part.j0 + 1 + input.choice(height - part.j0);
  }
  return part;
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const std::vector<std::string> targets = vectorTargets();
  FuzzInput input(data, size);
  // The film and the division of the work come first: they are short, and the scene uses all
  // remaining bytes.
  const FuzzFilm film(input);
  Settings settings;
  settings.tileShift = input.choice(7);
  settings.chunk = 1 + input.choice(32);
  settings.culling = !input.seldom();
  settings.binPages = input.seldom(64) ? 1 : settings.binPages;
  const int threads = input.seldom(32) ? 1 + input.choice(3) : 1;
  const int abortAfter = input.seldom(32) ? input.choice(8) : -1;
  useVectorTarget(targets[input.choice(static_cast<int>(targets.size()))]);
  settings.kernels = areVectorsInUse();
  const int width = 1 + input.choice(40), height = 1 + input.choice(40);
  const Window part = makePart(input, width, height);
  FuzzScene scene(input, width, height, film.hasPasses ? 2 : 0);
  scene.addSpheres(input);
  scene.addLines(input);
  scene.addTextures(input);
  scene.addStyles(input);
  scene.scene.backgroundImage = film.behind;
  if (findDefect(scene.scene.camera) != CameraDefect::None)
  {
    return 0;
  }

  const ThreadedParallel several(threads);
  const Parallel one;
  const Parallel& parallel = threads > 1 ? several : one;
  if (abortAfter >= 0)
  {
    draw(scene, film, part, settings, parallel, abortAfter); // must not crash
  }
  const Window all{ 0, width, 0, height };
  const Settings plain =
    Settings::bruteForce({ 0, film.samples * width, 0, film.samples * height });
  const Picture whole = draw(scene, film, all, plain, one);
  compare(scene, film, whole, draw(scene, film, part, settings, parallel), part);
  return 0;
}
