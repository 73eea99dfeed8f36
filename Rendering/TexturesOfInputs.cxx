// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TexturesOfInputs.h"

#include "InputName.h"

#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

#include <stdexcept>

namespace lambent::adapters
{
namespace
{
bool hasFaces(const SceneSettings::Input& input)
{
  return !input.spheres.areOn() &&
    input.mesh->GetNumberOfPolys() + input.mesh->GetNumberOfStrips() > 0;
}

[[noreturn]] void throwMissing(const std::string& name, const std::string& who)
{
  throw std::runtime_error(name + ": " + who +
    " no texture coordinates, which its vtkTexture needs. Compute them, for instance with "
    "vtkTextureMapToPlane, or call SetInputTexture() with nullptr.");
}
}

TexturesOfInputs::TexturesOfInputs(const std::vector<SceneSettings::Input>& inputs)
  : OfInputs(inputs.size(), nullptr)
{
  const SceneSettings::Input* lacking = nullptr; // first block without coordinates
  bool isShown = false;                          // by a block of the same connection
  for (std::size_t k = 0; k < inputs.size(); ++k)
  {
    const SceneSettings::Input& input = inputs[k];
    if (input.texture && hasFaces(input))
    {
      const bool hasCoordinates = input.mesh->GetPointData()->GetTCoords() != nullptr;
      if (!hasCoordinates && input.block < 0)
      {
        throwMissing(nameOf(input), "it has");
      }
      this->OfInputs[k] = hasCoordinates ? this->convert(input) : nullptr;
      isShown = isShown || hasCoordinates;
      lacking = lacking || hasCoordinates ? lacking : &input;
    }
    if (k + 1 == inputs.size() || inputs[k + 1].connection != input.connection)
    {
      if (lacking && !isShown)
      {
        throwMissing(nameOfInput(input.connection, -1, ""), "its blocks have");
      }
      lacking = nullptr;
      isShown = false;
    }
  }
}

const Texture* TexturesOfInputs::convert(const SceneSettings::Input& input)
{
  std::unique_ptr<TextureFromVTK>& converted = this->Converted[input.texture];
  if (!converted)
  {
    try
    {
      converted = std::make_unique<TextureFromVTK>(input.texture);
    }
    catch (const std::runtime_error& failure)
    {
      throw std::runtime_error(
        nameOfInput(input.connection, -1, "") + ": " + withinSentence(failure.what()));
    }
  }
  return &converted->texture();
}

std::vector<std::string> findIdleTextures(const SceneSettings& settings)
{
  std::vector<std::string> messages;
  int previous = -1; // blocks share their connection's settings
  for (const SceneSettings::Input& input : settings.inputs)
  {
    if (!input.texture || input.connection == previous)
    {
      continue;
    }
    previous = input.connection;
    const auto add = [&](bool isSet, const char* text)
    {
      if (isSet)
      {
        messages.push_back(nameOfInput(input.connection, -1, "") + ": " + text);
      }
    };
    add(input.spheres.areOn(),
      "SetInputTexture() has no effect, since spheres have no texture. Call it with nullptr, or "
      "SetInputSphereRadius() with 0.");
    const int blending = input.texture->GetBlendingMode();
    add(blending != vtkTexture::VTK_TEXTURE_BLENDING_MODE_NONE &&
        blending != vtkTexture::VTK_TEXTURE_BLENDING_MODE_MODULATE,
      "vtkTexture::SetBlendingMode() has no effect; the texture multiplies the colour of the "
      "surface. Set it back to VTK_TEXTURE_BLENDING_MODE_NONE.");
    add(input.texture->GetMipmap(),
      "vtkTexture::MipmapOn() has no effect. Call SetSupersampling() to average the texture where "
      "it is small, and MipmapOff().");
    vtkProperty* const property = settings.propertyOf(input);
    add(property && !property->GetShowTexturesOnBackface(),
      "vtkProperty::ShowTexturesOnBackfaceOff() has no effect; textures are on both sides. Call "
      "ShowTexturesOnBackfaceOn(), or connect the input twice and cull one side of each.");
  }
  return messages;
}
}
