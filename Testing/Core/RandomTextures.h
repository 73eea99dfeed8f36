// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief random textures for the surfaces of random scenes
 */
#ifndef RandomTextures_h
#define RandomTextures_h

#include "RandomNumbers.h"
#include "Scene.h"

#include <limits>
#include <memory>
#include <vector>

/// Gives most surfaces a texture: any wrapping, filter and type, with coordinates of 1 to 3
/// components, a few of which are not finite. It must outlive the scene.
class RandomTextures
{
public:
  RandomTextures(lambent::Scene& scene, unsigned int seed, bool hasAlpha = false)
    : Random(seed)
    , HasAlpha(hasAlpha)
  {
    for (lambent::Surface& surface : scene.surfaces)
    {
      if (this->Random.below(5) > 0)
      {
        surface.texture = this->add(surface.points.size);
      }
    }
  }

private:
  struct Data
  {
    std::vector<unsigned char> bytes;
    std::vector<std::uint16_t> words;
    std::vector<float> floats;
    std::vector<double> coordinates;
    std::vector<float> floatCoordinates;
    lambent::TextureMap map;
  };

  const lambent::TextureMap* add(std::size_t points)
  {
    auto data = std::make_unique<Data>();
    lambent::Texture& texture = data->map.texture;
    texture.hasAlpha = this->HasAlpha;
    texture.width = 1 + this->Random.below(9);
    texture.height = 1 + this->Random.below(9);
    const int components = 1 + this->Random.below(4);
    for (int k = 0; k < components * texture.width * texture.height; ++k)
    {
      const int bits = this->Random.below(65536);
      data->bytes.push_back(static_cast<unsigned char>(bits >> 8));
      data->words.push_back(static_cast<std::uint16_t>(bits));
      data->floats.push_back(static_cast<float>(bits) / 32768.0f);
    }
    const int type = this->Random.below(3);
    texture.pixels = type == 0 ? lambent::AttributeSpan{ data->bytes.data(),
      lambent::AttributeType::UInt8, components, false }
      : type == 1 ? lambent::AttributeSpan{ data->words.data(), lambent::AttributeType::UInt16,
          components, false }
                  : lambent::AttributeSpan{ data->floats.data(), lambent::AttributeType::Float,
                      components, false };
    texture.wrap = static_cast<lambent::TextureWrap>(this->Random.below(4));
    texture.isInterpolated = this->Random.below(2) == 0;
    texture.isSRGB = this->Random.below(2) == 0;
    for (auto& row : texture.matrix)
    {
      for (double& element : row)
      {
        element = this->Random.below(3) == 0 ? this->Random.within(-2.0, 2.0) : element;
      }
    }
    this->addCoordinates(*data, points);
    this->All.push_back(std::move(data));
    return &this->All.back()->map;
  }

  void addCoordinates(Data& data, std::size_t points)
  {
    const int components = 1 + this->Random.below(3);
    for (std::size_t k = 0; k < components * points; ++k)
    {
      const bool isBad = this->Random.below(200) == 0;
      data.coordinates.push_back(
        isBad ? std::numeric_limits<double>::quiet_NaN() : this->Random.within(-3.0, 3.0));
      data.floatCoordinates.push_back(static_cast<float>(data.coordinates.back()));
    }
    data.map.coordinates = this->Random.below(2) == 0
      ? lambent::AttributeSpan{ data.coordinates.data(), lambent::AttributeType::Double, components,
          false }
      : lambent::AttributeSpan{ data.floatCoordinates.data(), lambent::AttributeType::Float,
          components, false };
  }

  RandomNumbers Random;
  bool HasAlpha;
  std::vector<std::unique_ptr<Data>> All;
};

#endif
