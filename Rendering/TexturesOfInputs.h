// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the textures of all inputs
 *
 * An input needs texture coordinates, unless it has no faces. Of the blocks of a composite input,
 * only one needs some; the others are drawn without the texture.
 */
#ifndef TexturesOfInputs_h
#define TexturesOfInputs_h

#include "SceneSettings.h"
#include "TextureFromVTK.h"

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace lambent::adapters
{
class TexturesOfInputs
{
public:
  /// Converts each vtkTexture once. Throws std::runtime_error with a message that names the input.
  explicit TexturesOfInputs(const std::vector<SceneSettings::Input>& inputs);

  /// The texture of an input; nullptr if it has none or cannot show it.
  const Texture* of(std::size_t input) const { return this->OfInputs[input]; }

private:
  const Texture* convert(const SceneSettings::Input& input);

  std::unordered_map<vtkTexture*, std::unique_ptr<TextureFromVTK>> Converted;
  std::vector<const Texture*> OfInputs;
};

/// One message for each setting of textures that has no effect.
std::vector<std::string> findIdleTextures(const SceneSettings& settings);
}

#endif
