// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief make arbitrary scenes of the core from the bytes of a fuzzer
 */
#ifndef FuzzScene_h
#define FuzzScene_h

#include "FuzzInput.h"
#include "FuzzTexture.h"

#include "Scene.h"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

/// The number of components of each attribute.
constexpr int attributeComponents = 2;

inline lambent::Vec3 vector(FuzzInput& input)
{
  const double x = input.number(), y = input.number();
  return { x, y, input.number() };
}

inline lambent::Vec3 color(FuzzInput& input)
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

  lambent::TupleSpan span() const
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
  std::vector<std::vector<std::uint8_t>> attributes;
  std::array<std::uint8_t, 20> entries{};
  std::unique_ptr<lambent::ColorTable> table;
  lambent::ColorArray colors;
  lambent::Surface surface;

  MeshData(FuzzInput& input, int pointCount, int triangleCount, int attributeCount)
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
    lambent::Appearance& appearance = this->surface.appearance;
    appearance.shading = static_cast<lambent::Shading>(input.choice(3));
    appearance.cullFront = input.seldom();
    appearance.cullBack = input.seldom();
    appearance.diffuseColor = color(input);
    appearance.ambient = 1.0;
    appearance.ambientColor = color(input);
    for (int k = 0; k < attributeCount; ++k)
    {
      this->addAttribute(input, k % 2 == 0 ? pointCount : triangleCount, k % 2 != 0);
    }
    if (attributeCount > 0 && input.flag())
    {
      this->addColors(input);
    }
  }

  /// Takes the colours from an attribute, if it has values.
  void addColors(FuzzInput& input)
  {
    this->colors.values =
      this->surface.attributes[input.choice(static_cast<int>(this->surface.attributes.size()))];
    if (!this->colors.values)
    {
      return;
    }
    this->surface.colors = &this->colors;
    if (input.flag())
    {
      std::generate(this->entries.begin(), this->entries.end(), [&]() { return input.byte(); });
      const bool isLogarithmic = input.flag();
      const double low = isLogarithmic ? input.within(1e-9, 9.0) : input.within(-9.0, 9.0);
      this->table = std::make_unique<lambent::ColorTable>(this->entries.data(),
        this->entries.size() / 4, low, low + input.within(0.0, 9.0), isLogarithmic);
      this->colors.table = this->table.get();
      this->colors.component = input.choice(attributeComponents + 1) - 1;
      this->colors.isMappedLast = !this->colors.values.isPerCell && input.flag();
    }
  }

  /// Adds an attribute of any type, with arbitrary values or none.
  void addAttribute(FuzzInput& input, int tuples, bool isPerCell)
  {
    constexpr std::size_t sizeOfNumber = 8; // that of the largest types
    lambent::AttributeSpan span;
    span.type = static_cast<lambent::AttributeType>(input.choice(10));
    span.components = attributeComponents;
    span.isPerCell = isPerCell;
    this->attributes.emplace_back();
    if (!input.seldom(64))
    {
      std::vector<std::uint8_t>& memory = this->attributes.back();
      memory.resize(sizeOfNumber * static_cast<std::size_t>(attributeComponents * tuples) + 1);
      std::generate(memory.begin(), memory.end(), [&]() { return input.byte(); });
      span.data = memory.data();
    }
    this->surface.attributes.push_back(span);
  }
};

inline lambent::Light makeLight(FuzzInput& input)
{
  lambent::Light light;
  light.positional = input.flag();
  light.position = vector(input);
  light.direction = vector(input);
  light.color = color(input);
  light.coneAngle = input.number() * 30.0;
  light.exponent = input.number();
  light.attenuation = vector(input);
  return light;
}

inline lambent::Camera makeCamera(FuzzInput& input)
{
  lambent::Camera camera;
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
    camera.focalPoint = camera.position - lambent::Vec3(0.0, 0.0, 1.0);
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
  lambent::Scene scene;
  std::vector<std::unique_ptr<MeshData>> meshes;
  const int width, height;

  FuzzScene(FuzzInput& input, int imageWidth, int imageHeight, int attributeCount)
    : width(imageWidth)
    , height(imageHeight)
  {
    this->scene.camera = makeCamera(input);
    for (int lights = input.choice(3); lights > 0; --lights)
    {
      this->scene.lights.push_back(makeLight(input));
    }
    this->scene.ambientModel = static_cast<lambent::AmbientModel>(input.choice(2));
    this->scene.twoSidedLighting = input.flag();
    this->scene.background = color(input);
    this->scene.backgroundTop = color(input);
    for (int surfaces = input.choice(4); surfaces > 0; --surfaces)
    {
      const int points = input.choice(24), triangles = input.choice(32);
      this->meshes.push_back(std::make_unique<MeshData>(input, points, triangles, attributeCount));
      this->scene.surfaces.push_back(this->meshes.back()->surface);
    }
  }

  /// Turns some surfaces into spheres. Call it after everything else: then inputs that end before
  /// mean the same as without spheres.
  void addSpheres(FuzzInput& input)
  {
    for (lambent::Surface& surface : this->scene.surfaces)
    {
      if (input.choice(4) != 3)
      {
        continue;
      }
      surface.radius = input.flag() ? 1.0 : std::fabs(input.number());
      if (input.flag())
      {
        this->Radii.emplace_back();
        for (std::size_t k = 0; k < surface.points.size; ++k)
        {
          this->Radii.back().push_back(input.seldom(64) ? input.number() : input.within(0.0, 1.0));
        }
        surface.radii = { this->Radii.back().data(), true, this->Radii.back().size() };
      }
    }
  }

  /// Turns some surfaces of triangles into lines. Call it after addSpheres(), for the same reason.
  void addLines(FuzzInput& input)
  {
    for (lambent::Surface& surface : this->scene.surfaces)
    {
      if (surface.kind() != lambent::PrimitiveKind::Triangle || input.choice(4) != 3)
      {
        continue;
      }
      surface.corners.size = 2 * surface.triangleCount(); // there may be one cell for each triangle
      surface.width = input.flag() ? input.within(0.0, 20.0) : std::fabs(input.number());
      surface.isRounded = input.flag();
      if (surface.normalNumbers.data)
      {
        surface.pointNormals = lambent::TupleSpan(); // there may be fewer than points
      }
    }
  }

  /// Gives some surfaces textures. Call it after addSpheres().
  void addTextures(FuzzInput& input)
  {
    for (lambent::Surface& surface : this->scene.surfaces)
    {
      if (input.choice(4) == 3)
      {
        this->Textures.push_back(std::make_unique<FuzzTexture>(input, surface.points.size));
        surface.texture = &this->Textures.back()->map;
      }
    }
  }

  /// Gives some surfaces edges, highlights and an opacity. Call it after addSpheres(), for the same
  /// reason.
  void addStyles(FuzzInput& input)
  {
    for (lambent::Surface& surface : this->scene.surfaces)
    {
      const int kind = input.choice(4);
      if ((kind & 1) != 0)
      {
        lambent::EdgeStyle& edges = surface.appearance.edges;
        edges.areVisible = true;
        edges.width = std::fabs(input.number());
        edges.opacity = input.within(0.0, 1.0);
        edges.color = color(input);
        this->Flags.emplace_back(surface.triangleCount());
        std::generate(
          this->Flags.back().begin(), this->Flags.back().end(), [&]() { return input.byte(); });
        surface.cellEdges = input.flag() ? this->Flags.back().data() : nullptr;
      }
      if ((kind & 2) != 0)
      {
        surface.appearance.specular = { input.number(), color(input), std::fabs(input.number()) };
      }
      surface.appearance.opacity = input.choice(4) == 3 ? input.within(0.0, 1.0) : 1.0;
    }
  }

private:
  std::vector<std::vector<double>> Radii;
  std::vector<std::unique_ptr<FuzzTexture>> Textures;
  std::vector<std::vector<std::uint8_t>> Flags;
};

#endif
