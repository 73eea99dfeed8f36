// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stage.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace
{
template <typename Value>
std::vector<unsigned char> toMemory(const std::vector<double>& values)
{
  std::vector<unsigned char> memory(values.size() * sizeof(Value));
  for (std::size_t k = 0; k < values.size(); ++k)
  {
    const auto value = static_cast<Value>(values[k]);
    std::memcpy(&memory[k * sizeof(Value)], &value, sizeof(Value));
  }
  return memory;
}

/// The nearest number that the type can represent.
double rounded(double value, lambent::AttributeType type)
{
  return type == lambent::AttributeType::Float ? static_cast<double>(static_cast<float>(value))
    : type == lambent::AttributeType::Double   ? value
                                               : std::floor(value);
}
}

std::vector<unsigned char> StageArray::memory() const
{
  switch (this->type)
  {
    case lambent::AttributeType::UInt8:
      return toMemory<std::uint8_t>(this->values);
    case lambent::AttributeType::Int32:
      return toMemory<std::int32_t>(this->values);
    case lambent::AttributeType::Double:
      return toMemory<double>(this->values);
    default:
      return toMemory<float>(this->values);
  }
}

Body& Body::paint(const Vec3& diffuse, const Vec3& ambient)
{
  this->appearance.diffuseColor = diffuse;
  this->appearance.ambient = 1.0;
  this->appearance.ambientColor = ambient;
  return *this;
}

Body& Body::flat()
{
  this->appearance.shading = lambent::Shading::Flat;
  return *this;
}

Body& Body::unlit()
{
  this->appearance.shading = lambent::Shading::Unlit;
  return *this;
}

Body& Body::weigh(lambent::Weighting how)
{
  this->weighting = how;
  return *this;
}

Body& Body::round()
{
  this->pointNormals = this->shape.points;
  return *this;
}

Body& Body::floats()
{
  this->hasFloatPoints = true;
  this->has32BitIds = true;
  return *this;
}

Body& Body::strips()
{
  this->hasStrips = true;
  return *this;
}

Body& Body::spheres(double size)
{
  this->radius = size;
  return *this;
}

Body& Body::spheres(double factor, const std::vector<double>& sizes)
{
  this->radii = sizes;
  return this->spheres(factor);
}

Body& Body::lines(CellShow how, double pixels)
{
  this->show = how;
  this->width = pixels;
  return *this;
}

Body& Body::tubes(CellShow how, double pixels)
{
  this->isRounded = true;
  return this->lines(how, pixels);
}

Body& Body::place(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& offset)
{
  this->transform = { { { x.x, x.y, x.z, offset.x }, { y.x, y.y, y.z, offset.y },
    { z.x, z.y, z.z, offset.z } } };
  return *this;
}

Body& Body::inBlock(const std::vector<int>& path)
{
  this->block = path;
  return *this;
}

Body& Body::pointArray(const std::string& name, int components, lambent::AttributeType type)
{
  StageArray array{ name, false, components, type, {} };
  for (const Vec3& p : this->shape.points)
  {
    const double values[4] = { 100.0 + 50.0 * p.x, 100.0 - 25.0 * p.y, 10.0 + p.z * p.z,
      64.0 * p.x * p.x };
    for (int k = 0; k < components; ++k)
    {
      array.values.push_back(rounded(values[k], type));
    }
  }
  this->arrays.push_back(array);
  return *this;
}

Body& Body::cellArray(const std::string& name, int components, lambent::AttributeType type)
{
  StageArray array{ name, true, components, type, {} };
  for (std::size_t k = 0; k < this->shape.cells.size() * static_cast<std::size_t>(components); ++k)
  {
    array.values.push_back(rounded(static_cast<double>(37 * k % 101) + 0.3125, type));
  }
  this->arrays.push_back(array);
  return *this;
}

StageColors& Body::colorBy(const std::string& name, bool isPerCell)
{
  this->colors.array = name;
  this->colors.isPerCell = isPerCell;
  return this->colors;
}

StageTexture& StageTexture::wrapped(lambent::TextureWrap how)
{
  this->wrap = how;
  return *this;
}

StageTexture& StageTexture::interpolated()
{
  this->isInterpolated = true;
  return *this;
}

StageTexture& Body::cover(int w, int h, int components, lambent::AttributeType type)
{
  StageTexture& result = this->texture;
  result.width = w;
  result.height = h;
  result.pixels = { "Pixels", false, components, type, {} };
  const bool isFloat = type == lambent::AttributeType::Float;
  for (int pixel = 0; pixel < w * h; ++pixel)
  {
    const int i = pixel % w, j = pixel / w;
    for (int k = 0; k < components; ++k)
    {
      const int byte = (i / 2 + j / 2) % 2 == 0 ? 255 - 16 * k : (23 * i + 41 * j * (k + 1)) % 256;
      result.pixels.values.push_back(isFloat ? byte / 256.0 : byte);
    }
  }
  result.coordinates = { "Places", false, 2, lambent::AttributeType::Float, {} };
  for (const Vec3& p : this->shape.points)
  {
    result.coordinates.values.push_back(rounded(p.x, lambent::AttributeType::Float));
    result.coordinates.values.push_back(rounded(p.y + 0.5 * p.z, lambent::AttributeType::Float));
  }
  return result;
}

Stage::Stage()
{
  this->look({ 2.0, 1.5, 4.0 }, Vec3(0.0));
  this->scene.background = this->scene.backgroundTop = { 0.0625, 0.125, 0.25 };
}

bool Stage::isHidden(const Body& body) const
{
  return std::any_of(this->hiddenBlocks.begin(), this->hiddenBlocks.end(),
    [&](const std::vector<int>& hidden)
    {
      return hidden.size() <= body.block.size() &&
        std::equal(hidden.begin(), hidden.end(), body.block.begin());
    });
}

std::vector<Body> Stage::visibleBodies() const
{
  std::vector<Body> result;
  const Body* first = nullptr; // of the composite input
  for (const Body& body : this->bodies)
  {
    first = body.block.empty() ? nullptr : first ? first : &body;
    if (this->isHidden(body))
    {
      continue;
    }
    result.push_back(body);
    if (first)
    {
      lambent::Appearance& appearance = result.back().appearance;
      appearance = first->appearance;
      appearance.diffuseColor = body.blockColor.value_or(appearance.diffuseColor);
      appearance.ambientColor = body.blockColor.value_or(appearance.ambientColor);
      appearance.opacity = body.blockOpacity.value_or(appearance.opacity);
      result.back().transform = first->transform;
      result.back().block.clear();
    }
  }
  return result;
}

Body& Stage::add(const Shape& shape)
{
  this->bodies.emplace_back();
  this->bodies.back().shape = shape;
  return this->bodies.back().paint({ 0.9, 0.8, 0.7 }, { 0.05, 0.06, 0.07 });
}

void Stage::size(int w, int h)
{
  this->width = w;
  this->height = h;
}

void Stage::look(const Vec3& from, const Vec3& at, const Vec3& up)
{
  this->scene.camera.position = from;
  this->scene.camera.focalPoint = at;
  this->scene.camera.viewUp = up;
}

void Stage::lookParallel(double scale)
{
  this->scene.camera.parallel = true;
  this->scene.camera.parallelScale = scale;
}

void Stage::showDepth()
{
  this->passes.push_back({ lambent::PassContent::Depth, "Depth", false });
}

void Stage::showNormals()
{
  this->passes.push_back({ lambent::PassContent::Normal, "Normals", false });
}

void Stage::showPositions()
{
  this->passes.push_back({ lambent::PassContent::Position, "Positions", false });
}

void Stage::showArray(const std::string& name, bool isPerCell)
{
  this->passes.push_back({ lambent::PassContent::Attribute, name, isPerCell });
}

void Stage::imageBehind(int w, int h, int components, lambent::AttributeType type)
{
  RandomNumbers random(97);
  const bool isBytes = type == lambent::AttributeType::UInt8;
  this->backgroundWidth = w;
  this->backgroundHeight = h;
  this->backgroundImage = { "Color", false, components, type, {} };
  for (int k = 0; k < w * h * components; ++k)
  {
    this->backgroundImage.values.push_back(
      rounded(isBytes ? random.within(0.0, 256.0) : random.within(0.0, 1.0), type));
  }
}

lambent::Light& Stage::sun(const Vec3& direction, const Vec3& color)
{
  this->scene.lights.emplace_back();
  lambent::Light& light = this->scene.lights.back();
  light.direction = direction;
  light.color = color;
  return light;
}

lambent::Light& Stage::lamp(const Vec3& position, const Vec3& color)
{
  lambent::Light& light = this->sun({ 0.0, 0.0, -1.0 }, color);
  light.positional = true;
  light.position = position;
  return light;
}

lambent::Light& Stage::spot(
  const Vec3& position, const Vec3& direction, double angle, double exponent)
{
  lambent::Light& light = this->lamp(position);
  light.direction = direction;
  light.coneAngle = angle;
  light.exponent = exponent;
  return light;
}

void Stage::daylight()
{
  this->sun({ -1.0, -2.0, -1.5 }, { 0.75, 0.7, 0.6 });
  this->lamp({ -3.0, 1.0, 2.0 }, { 0.2, 0.3, 0.5 });
}
