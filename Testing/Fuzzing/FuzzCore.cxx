// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The core: for any scene, any division of the work and any vectors, the picture is that of brute
// force, bit for bit, and the defects of the mesh are the same.
#include "FuzzInput.h"

#include "CameraFrame.h"
#include "Render.h"
#include "ThreadedParallel.h"

#include <memory>
#include <string>
#include <vector>

using namespace lambent;

namespace
{
Vec3 vector(FuzzInput& input)
{
  const double x = input.number(), y = input.number();
  return { x, y, input.number() };
}

Vec3 color(FuzzInput& input)
{
  const double red = input.within(0.0, 1.0), green = input.within(0.0, 1.0);
  return { red, green, input.within(0.0, 1.0) };
}

/// Points or normals, as float or as double.
struct Tuples
{
  std::vector<double> doubles;
  std::vector<float> floats;
  bool isDouble = false;

  Tuples(FuzzInput& input, int count)
    : isDouble(input.flag())
  {
    for (int k = 0; k < 3 * count; ++k)
    {
      this->doubles.push_back(input.number());
      this->floats.push_back(toFloat(this->doubles.back()));
    }
  }

  TupleSpan span() const
  {
    return { this->isDouble ? static_cast<const void*>(this->doubles.data()) : this->floats.data(),
      this->isDouble, this->doubles.size() / 3 };
  }

private:
  /// A cast would be undefined for values that a float cannot represent.
  static float toFloat(double value)
  {
    constexpr double largest = std::numeric_limits<float>::max();
    return std::isnan(value) || std::fabs(value) <= largest
      ? static_cast<float>(value)
      : std::copysign(std::numeric_limits<float>::infinity(), static_cast<float>(value > 0) - 0.5f);
  }
};

struct MeshData
{
  Tuples points, pointNormals, cellNormals;
  std::vector<std::int32_t> corners32;
  std::vector<std::int64_t> corners64;
  Surface surface;

  MeshData(FuzzInput& input, int pointCount, int triangleCount)
    : points(input, pointCount)
    , pointNormals(input, input.flag() ? pointCount : 0)
    , cellNormals(input, input.flag() ? triangleCount : 0)
  {
    for (int k = 0; k < 3 * triangleCount; ++k)
    {
      const int id = input.byte();
      const bool isWild = id == 255;
      this->corners64.push_back(isWild ? input.raw<std::int32_t>() : id % std::max(1, pointCount));
      this->corners32.push_back(static_cast<std::int32_t>(this->corners64.back()));
    }
    this->surface.points = this->points.span();
    if (input.flag())
    {
      this->surface.corners = { this->corners32.data(), false, this->corners32.size() };
    }
    else
    {
      this->surface.corners = { this->corners64.data(), true, this->corners64.size() };
    }
    if (this->pointNormals.span().size > 0)
    {
      this->surface.pointNormals = this->pointNormals.span();
    }
    if (this->cellNormals.span().size > 0)
    {
      this->surface.cellNormals = this->cellNormals.span();
    }
    Appearance& appearance = this->surface.appearance;
    appearance.shading = static_cast<Shading>(input.choice(3));
    appearance.cullFront = input.seldom();
    appearance.cullBack = input.seldom();
    appearance.diffuseColor = color(input);
    appearance.ambient = 1.0;
    appearance.ambientColor = color(input);
  }
};

Light makeLight(FuzzInput& input)
{
  Light light;
  light.positional = input.flag();
  light.position = vector(input);
  light.direction = vector(input);
  light.color = color(input);
  light.coneAngle = input.number() * 30.0;
  light.exponent = input.number();
  light.attenuation = vector(input);
  return light;
}

Camera makeCamera(FuzzInput& input)
{
  Camera camera;
  camera.parallel = input.flag();
  camera.horizontalViewAngle = input.flag();
  if (input.flag())
  {
    camera.position = vector(input);
    camera.focalPoint = vector(input);
    camera.viewUp = vector(input);
  }
  else
  {
    camera.position = { 0.0, 0.0, input.within(-2.0, 5.0) };
    camera.focalPoint = camera.position - Vec3(0.0, 0.0, 1.0);
  }
  camera.viewAngle = input.seldom() ? input.number() : input.within(1.0, 170.0);
  camera.parallelScale = input.seldom() ? input.number() : input.within(0.25, 4.0);
  if (input.seldom(32))
  {
    camera.windowCenter[0] = input.number();
    camera.windowCenter[1] = input.number();
  }
  return camera;
}

struct FuzzScene
{
  Scene scene;
  std::vector<std::unique_ptr<MeshData>> meshes;
  const int width, height;

  FuzzScene(FuzzInput& input, int imageWidth, int imageHeight)
    : width(imageWidth)
    , height(imageHeight)
  {
    this->scene.camera = makeCamera(input);
    for (int lights = input.choice(3); lights > 0; --lights)
    {
      this->scene.lights.push_back(makeLight(input));
    }
    this->scene.ambientModel = static_cast<AmbientModel>(input.choice(2));
    this->scene.twoSidedLighting = input.flag();
    this->scene.background = color(input);
    this->scene.backgroundTop = color(input);
    for (int surfaces = input.choice(4); surfaces > 0; --surfaces)
    {
      const int points = input.choice(24), triangles = input.choice(32);
      this->meshes.push_back(std::make_unique<MeshData>(input, points, triangles));
      this->scene.surfaces.push_back(this->meshes.back()->surface);
    }
  }
};

struct Picture
{
  std::vector<float> floats;
  Report report;
};

Picture draw(const FuzzScene& from, int samples, const Window& part, const Settings& settings,
  const Parallel& parallel, int abortAfter = -1)
{
  Picture picture;
  picture.floats.assign(3u * part.width() * part.height(), -1.0f);
  Image image;
  image.width = from.width;
  image.height = from.height;
  image.part = part;
  image.samples = samples;
  image.floats = picture.floats.data();
  picture.report = render(
    from.scene, image, parallel, [&abortAfter](double) { return abortAfter-- != 0; }, settings);
  return picture;
}

/// The bits of a NaN may differ, since the contract only covers numbers.
bool areSame(float a, float b)
{
  return std::memcmp(&a, &b, sizeof(float)) == 0 || (std::isnan(a) && std::isnan(b));
}

void compare(
  const FuzzScene& from, const Picture& whole, const Picture& picture, const Window& part)
{
  require(picture.report.outcome == whole.report.outcome, "the outcome is that of brute force");
  const MeshDefects &a = whole.report.defects, &b = picture.report.defects;
  require(a.wrongCorner == b.wrongCorner, "the first wrong corner is the same");
  if (whole.report.outcome == Outcome::BadMesh)
  {
    return;
  }
  require(a.notFinite == b.notFinite && a.firstNotFinite == b.firstNotFinite,
    "the cells that are not finite are the same");
  std::size_t k = 0;
  for (int j = part.j0; j < part.j1; ++j)
  {
    for (int i = 3 * part.i0; i < 3 * part.i1; ++i, ++k)
    {
      require(areSame(picture.floats[k], whole.floats[3u * from.width * j + i]),
        "each channel is that of brute force");
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
  // The division of the work comes first: it is short, and the scene uses all remaining bytes.
  const int samples = 1 + input.choice(4);
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
  const FuzzScene scene(input, width, height);
  if (findDefect(scene.scene.camera) != CameraDefect::None)
  {
    return 0;
  }

  const ThreadedParallel several(threads);
  const Parallel one;
  const Parallel& parallel = threads > 1 ? several : one;
  if (abortAfter >= 0)
  {
    draw(scene, samples, part, settings, parallel, abortAfter); // must not crash
  }
  const Window all{ 0, width, 0, height };
  const Settings plain = Settings::bruteForce({ 0, samples * width, 0, samples * height });
  const Picture whole = draw(scene, samples, all, plain, one);
  compare(scene, whole, draw(scene, samples, part, settings, parallel), part);
  return 0;
}
