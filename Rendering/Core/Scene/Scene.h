// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the scene as plain data: surfaces, lights, camera, background
 *
 * The input of the renderer, without VTK. Spans point into memory that the caller keeps alive while
 * the image is rendered. Nothing is copied or modified.
 */
#ifndef lambent_Scene_h
#define lambent_Scene_h

#include "Surface.h"

#include <vector>

namespace lambent
{
struct Light
{
  bool positional = false;
  Vec3 position{ 0.0, 0.0, 1.0 };    ///< of a positional light
  Vec3 direction{ 0.0, 0.0, -1.0 };  ///< of the light, and axis of its cone; any length
  Vec3 color{ 1.0 };                 ///< colour x intensity
  Vec3 specularColor{ 1.0 };         ///< of its highlights; colour x intensity
  double coneAngle = 90.0;           ///< degrees from axis to rim; 90 or more: no cone
  double exponent = 1.0;             ///< of the fall-off from the axis, within the cone
  Vec3 attenuation{ 1.0, 0.0, 0.0 }; ///< constant, linear, quadratic
};

enum class AmbientModel
{
  PerLight, ///< rho_a times each light
  Scene     ///< rho_a once
};

struct Camera
{
  Vec3 position{ 0.0, 0.0, 1.0 };
  Vec3 focalPoint{ 0.0 };
  Vec3 viewUp{ 0.0, 1.0, 0.0 };
  double viewAngle = 30.0; ///< degrees
  bool horizontalViewAngle = false;
  bool parallel = false;
  double parallelScale = 1.0; ///< half the height of the image, in world units
  double windowCenter[2] = { 0.0, 0.0 };
};

/// An image behind the surfaces, stretched to the size of the whole picture.
struct BackgroundImage
{
  /// Rows from the bottom; 1 to 4 components: grey, grey and alpha, RGB or RGBA. Bytes c mean
  /// c / 255, other types are used as they are. Alpha is straight. Empty if there is no image.
  AttributeSpan pixels;
  int width = 0, height = 0;
};

struct Scene
{
  std::vector<Surface> surfaces;
  std::vector<Light> lights;
  Camera camera;
  AmbientModel ambientModel = AmbientModel::PerLight;
  bool twoSidedLighting = true;
  Vec3 background{ 0.0 };    ///< at the bottom edge
  Vec3 backgroundTop{ 0.0 }; ///< at the top edge
  BackgroundImage backgroundImage;
};
}

#endif
