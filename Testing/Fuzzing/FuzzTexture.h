// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief make an arbitrary texture of the core from the bytes of a fuzzer
 */
#ifndef FuzzTexture_h
#define FuzzTexture_h

#include "FuzzInput.h"

#include "Texture.h"

#include <vector>

struct FuzzTexture
{
  lambent::TextureMap map;
  std::vector<float> pixels;
  std::vector<double> coordinates;

  FuzzTexture(FuzzInput& input, std::size_t points)
  {
    lambent::Texture& texture = this->map.texture;
    const int kind = input.byte();
    texture.wrap = static_cast<lambent::TextureWrap>(kind & 3);
    texture.isInterpolated = (kind & 4) != 0;
    texture.isSRGB = (kind & 8) != 0;
    const int components = 1 + ((kind >> 4) & 3);
    texture.width = 1 + input.choice(5);
    texture.height = 1 + input.choice(5);
    for (int k = 0; k < texture.width * texture.height * components; ++k)
    {
      this->pixels.push_back(
        input.seldom(32) ? input.raw<float>() : static_cast<float>(input.within(-0.5, 1.5)));
    }
    // The bytes of floats are also valid as bytes and words.
    const lambent::AttributeType types[] = { lambent::AttributeType::UInt8,
      lambent::AttributeType::UInt16, lambent::AttributeType::Float };
    texture.pixels = { this->pixels.data(), types[input.choice(3)], components, false };
    for (double* const row : { texture.matrix[0], texture.matrix[1] })
    {
      for (int k = 0; k < 3; ++k)
      {
        row[k] = input.seldom(64) ? input.number() : row[k];
      }
    }
    const int ofCoordinates = 1 + input.choice(3);
    for (std::size_t k = 0; k < ofCoordinates * points + 1; ++k)
    {
      this->coordinates.push_back(input.number());
    }
    this->map.coordinates = { this->coordinates.data(), lambent::AttributeType::Double,
      ofCoordinates, false };
  }
};

#endif
