// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the scene as plain data: surfaces, materials, lights, camera
 *
 * What goes into a picture, without VTK. Spans point into memory that the caller
 * keeps alive while the picture is made; nothing is copied and nothing written.
 */
#ifndef lambent_Scene_h
#define lambent_Scene_h

#include "Arithmetic.h"
#include "Spans.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace lambent
{
enum class Shading
{
  Smooth, ///< interpolated point normals; flat where a surface has none
  Flat,   ///< cell normals, the triangle's own where a surface has none
  Unlit   ///< the plain colour
};

struct Material
{
  Vec3 diffuse{ 1.0 }; ///< rho_d, coefficient x colour
  Vec3 ambient{ 0.0 }; ///< rho_a, coefficient x colour
  Vec3 color{ 1.0 };   ///< what an unlit surface shows
  Shading shading = Shading::Smooth;
  bool cullFront = false; ///< front faces (counter-clockwise) are not there
  bool cullBack = false;  ///< back faces are not there
};

/// A triangle mesh: triangle t has the corners 3t, 3t+1, 3t+2.
struct Surface
{
  TupleSpan points;
  IndexSpan corners;
  TupleSpan pointNormals; ///< one a point, or none
  /// Where corners at one point have different normals: which of pointNormals each corner
  /// has. None: the one of its point.
  IndexSpan normalNumbers;
  TupleSpan cellNormals; ///< one a cell, or none
  /// The cell of each triangle; nullptr: cell = firstCell + triangle.
  const std::int64_t* cells = nullptr;
  std::int64_t firstCell = 0;
  Material material;

  bool isSmooth() const { return this->material.shading == Shading::Smooth && this->pointNormals; }
  const IndexSpan& normalsOfCorners() const
  {
    return this->normalNumbers.data ? this->normalNumbers : this->corners;
  }
  std::size_t triangleCount() const { return this->corners.size / 3; }
  std::int64_t cellOf(std::size_t triangle) const
  {
    return this->cells ? this->cells[triangle]
                       : this->firstCell + static_cast<std::int64_t>(triangle);
  }
};

struct Light
{
  bool positional = false;
  Vec3 position{ 0.0, 0.0, 1.0 };    ///< of a positional light
  Vec3 direction{ 0.0, 0.0, -1.0 };  ///< in which it shines; the cone's axis; any length
  Vec3 color{ 1.0 };                 ///< colour x intensity
  double coneAngle = 90.0;           ///< degrees from axis to rim; 90 and more: no cone
  double exponent = 1.0;             ///< fall-off from the axis, within the cone
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
  double parallelScale = 1.0; ///< half of the image's height
  double windowCenter[2] = { 0.0, 0.0 };
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
};
}

#endif
