// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomAttributes.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

using namespace lambent;

namespace
{
constexpr std::size_t typeCount = 10;
constexpr std::size_t attributeCount = 2 * typeCount;

/// Random numbers, occasionally NaN with a payload, infinity, -0 or a number beyond float.
template <typename Value>
Value realNumber(RandomNumbers& random)
{
  switch (random.below(40))
  {
    case 0:
      return std::copysign(static_cast<Value>(std::nan("0x155")), static_cast<Value>(-1));
    case 1:
      return std::numeric_limits<Value>::infinity();
    case 2:
      return static_cast<Value>(-0.0);
    case 3:
      return std::numeric_limits<Value>::max();
    default:
      return static_cast<Value>(random.within(-10.0, 10.0));
  }
}

template <typename Value>
Value number(RandomNumbers& random)
{
  if constexpr (std::is_floating_point_v<Value>)
  {
    return realNumber<Value>(random);
  }
  else
  {
    using Limits = std::numeric_limits<Value>;
    const double lowest = static_cast<double>(Limits::min());
    const double x = random.within(lowest, static_cast<double>(Limits::max()));
    return static_cast<Value>(std::min(std::floor(x), std::ldexp(1.0, Limits::digits - 1)));
  }
}
}

RandomAttributes::RandomAttributes(RandomScene& random, unsigned int seed)
  : Random(seed)
{
  for (std::size_t k = 0; k < attributeCount; ++k)
  {
    this->Components.push_back(1 + this->Random.below(4));
  }
  for (std::size_t k = 0; k < random.scene.surfaces.size(); ++k)
  {
    Surface& surface = random.scene.surfaces[k];
    this->addCells(surface);
    std::int64_t last = 0;
    for (std::size_t t = 0; t < surface.triangleCount(); ++t)
    {
      last = std::max(last, surface.cellOf(t));
    }
    const auto cells = static_cast<std::size_t>(last) + 1;
    this->addNormals(*random.meshes[k], surface, cells);
    this->values.emplace_back(attributeCount);
    for (std::size_t attribute = 0; attribute < attributeCount; ++attribute)
    {
      const bool isPerCell = attribute >= typeCount;
      this->addAttribute(surface, attribute, isPerCell ? cells : surface.points.size);
    }
  }
  this->addPasses();
}

void RandomAttributes::addPasses()
{
  const auto isDouble = [this]() { return this->Random.below(2) == 0; };
  this->passes = { { PassContent::Depth, 1, isDouble(), nullptr, 0 },
    { PassContent::Normal, 3, isDouble(), nullptr, 0 },
    { PassContent::Position, 3, isDouble(), nullptr, 0 } };
  for (std::size_t k = 0; k < attributeCount; ++k)
  {
    this->passes.push_back({ PassContent::Attribute, this->Components[k], isDouble(), nullptr, k });
  }
  this->passes.push_back({ PassContent::Attribute, 2, false, nullptr, attributeCount });
}

/// Makes cells of one or several triangles, after other cells that are not faces.
void RandomAttributes::addCells(Surface& surface)
{
  constexpr std::size_t largeMesh = 100000;
  const std::size_t trianglesPerCell =
    surface.triangleCount() > largeMesh ? 2 : 1 + this->Random.below(3);
  surface.firstCell = this->Random.below(5);
  if (trianglesPerCell > 1)
  {
    this->Cells.emplace_back();
    for (std::size_t t = 0; t < surface.triangleCount(); ++t)
    {
      this->Cells.back().push_back(
        surface.firstCell + static_cast<std::int64_t>((t / trianglesPerCell) % 1000));
    }
    surface.cells = this->Cells.back().data();
  }
}

void RandomAttributes::addNormals(RandomScene::MeshData& mesh, Surface& surface, std::size_t cells)
{
  if (this->Random.below(4) == 0)
  {
    std::fill_n(mesh.normals.begin(), mesh.normals.size() / 2, 0.0f);
  }
  if (surface.appearance.shading != Shading::Smooth && this->Random.below(2) == 0)
  {
    this->CellNormals.emplace_back();
    for (std::size_t k = 0; k < 3 * cells; ++k)
    {
      this->CellNormals.back().push_back(this->Random.within(-2.0, 2.0));
    }
    surface.cellNormals = { this->CellNormals.back().data(), true, cells };
  }
}

void RandomAttributes::addAttribute(Surface& surface, std::size_t number, std::size_t tuples)
{
  AttributeSpan span;
  span.type = static_cast<AttributeType>(number % typeCount);
  span.components = this->Components[number];
  span.isPerCell = number >= typeCount;
  const std::size_t count = tuples * static_cast<std::size_t>(span.components);
  std::vector<double>& copy = this->values.back()[number];
  if (this->Random.below(5) > 0)
  {
    const auto with = [&](auto zero) { this->fill<decltype(zero)>(span, count, copy); };
    switch (span.type)
    {
      case AttributeType::Int8:
        with(std::int8_t());
        break;
      case AttributeType::UInt8:
        with(std::uint8_t());
        break;
      case AttributeType::Int16:
        with(std::int16_t());
        break;
      case AttributeType::UInt16:
        with(std::uint16_t());
        break;
      case AttributeType::Int32:
        with(std::int32_t());
        break;
      case AttributeType::UInt32:
        with(std::uint32_t());
        break;
      case AttributeType::Int64:
        with(std::int64_t());
        break;
      case AttributeType::UInt64:
        with(std::uint64_t());
        break;
      case AttributeType::Float:
        with(float());
        break;
      case AttributeType::Double:
        with(double());
    }
  }
  surface.attributes.push_back(span);
}

template <typename Value>
void RandomAttributes::fill(AttributeSpan& span, std::size_t count, std::vector<double>& copy)
{
  this->Memory.emplace_back(count * sizeof(Value));
  for (std::size_t k = 0; k < count; ++k)
  {
    const auto value = number<Value>(this->Random);
    std::memcpy(this->Memory.back().data() + k * sizeof(Value), &value, sizeof(Value));
    copy.push_back(static_cast<double>(value));
  }
  span.data = this->Memory.back().data();
}
