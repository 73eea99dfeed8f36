// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the scene that a ray tracer's settings and inputs describe
 */
#ifndef SceneFromSettings_h
#define SceneFromSettings_h

#include "InputSurfaces.h"
#include "SceneSettings.h"
#include "TexturesOfInputs.h"

#include <optional>

namespace lambent::adapters
{
class SceneFromSettings
{
public:
  /// Roughly the share of the work that computing normals takes, if some are needed.
  static constexpr double normalsShare = 0.7;

  /// Creates surfaces, camera, lights and background. The settings and their inputs must outlive
  /// this object. Throws std::runtime_error with a message for the user, and whatever the
  /// checkpoints of `parallel` throw.
  SceneFromSettings(const SceneSettings& settings, const Parallel& parallel);

  const Scene& scene() const { return this->Description; }
  const InputSurfaces& surfaces() const { return this->Surfaces; }

private:
  static std::vector<Appearance> appearances(const SceneSettings& settings);
  static std::vector<LineStyle> lineStyles(const SceneSettings& settings);
  void addCamera(const Parallel& parallel);
  void addLights();
  void addBackground();
  void addSurfaces(const Parallel& parallel);

  const SceneSettings& Settings;
  InputSurfaces Surfaces;
  std::vector<InputColors> Colors; ///< of the inputs
  std::optional<TexturesOfInputs> Textures;
  SpansFromVTK BackgroundSpans;
  Scene Description;
};
}

#endif
