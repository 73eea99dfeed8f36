// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// Textures: wrapping, filters, pixel types, and what they are combined with. The images are
// computed (Body::cover()).
#include "Scenes.h"

#include <algorithm>
#include <limits>

using lambent::AttributeType;
using lambent::TextureWrap;

namespace
{
/// A hilly sheet and a ball with normals of their own, both with a texture.
void covered(Stage& s, int components = 3, AttributeType type = AttributeType::UInt8)
{
  s.daylight();
  s.add(moved(hills(12), { 0.0, -0.5, 0.0 })).flat().cover(13, 9, components, type);
  Body& globe = s.add(moved(ball(3), { 0.25, 0.75, 0.5 }));
  for (const Vec3& p : globe.shape.points)
  {
    globe.pointNormals.emplace_back(p.x - 0.25, p.y - 0.75, p.z - 0.5);
  }
  globe.cover(8, 16, components, type);
  for (Body& body : s.bodies)
  {
    body.appearance.ambient = 0.25;
  }
}

/// Doubles the coordinates and moves them by half an image.
void enlarge(StageTexture& texture)
{
  const double matrix[2][3] = { { 2.0, 0.0, 0.5 }, { 0.0, 2.0, 0.5 } };
  std::copy(&matrix[0][0], &matrix[0][0] + 6, &texture.matrix[0][0]);
}
}

SceneList textureScenes()
{
  return {
    { "texture-nearest-repeated", [](Stage& s) { covered(s); } },
    { "texture-interpolated-repeated",
      [](Stage& s)
      {
        covered(s);
        s.bodies[0].texture.interpolated();
        s.bodies[1].texture.interpolated();
      } },
    { "texture-mirrored-grey-and-alpha",
      [](Stage& s)
      {
        covered(s, 2);
        s.bodies[0].texture.wrapped(TextureWrap::MirroredRepeat);
        s.bodies[1].texture.wrapped(TextureWrap::MirroredRepeat).interpolated();
      } },
    { "texture-clamped-grey",
      [](Stage& s)
      {
        covered(s, 1);
        s.bodies[0].texture.wrapped(TextureWrap::ClampToEdge).interpolated();
        s.bodies[1].texture.wrapped(TextureWrap::ClampToEdge);
      } },
    { "texture-border-rgba",
      [](Stage& s)
      {
        covered(s, 4);
        for (Body& body : s.bodies)
        {
          body.texture.wrapped(TextureWrap::ClampToBorder).border = { 0.25, 0.75, 0.5 };
        }
        s.bodies[0].texture.interpolated();
      } },
    { "texture-floats",
      [](Stage& s)
      {
        covered(s, 3, AttributeType::Float);
        s.bodies[0].texture.interpolated();
      } },
    { "texture-srgb",
      [](Stage& s)
      {
        covered(s);
        s.bodies[0].texture.isSRGB = s.bodies[1].texture.isSRGB = true;
        s.bodies[1].texture.interpolated();
      } },
    { "texture-matrix",
      [](Stage& s)
      {
        covered(s);
        enlarge(s.bodies[0].texture);
        const double turn[2][3] = { { 0.75, -0.5, 0.125 }, { 0.5, 0.75, -0.25 } };
        std::copy(&turn[0][0], &turn[0][0] + 6, &s.bodies[1].texture.matrix[0][0]);
      } },
    { "texture-unlit-and-plain",
      [](Stage& s)
      {
        covered(s);
        s.bodies[0].unlit();
        s.bodies[1].unlit().texture.interpolated();
        s.add(moved(box({ 0.5, 0.25, 0.5 }), { -0.75, 0.5, 0.0 }))
          .paint({ 0.75, 0.25, 0.5 })
          .flat();
        s.add(moved(ball(1), { -0.5, 1.25, -0.5 })).spheres(0.125);
      } },
    { "texture-on-colours-of-arrays",
      [](Stage& s)
      {
        covered(s);
        s.bodies[0].cellArray("Shade", 3, AttributeType::UInt8).colorBy("Shade", true);
        s.bodies[1].pointArray("Paint", 3, AttributeType::UInt8).colorBy("Paint", false);
      } },
    { "texture-coordinates-of-one-and-three-components",
      [](Stage& s)
      {
        covered(s);
        for (int k = 0; k < 2; ++k)
        {
          StageArray& places = s.bodies[k].texture.coordinates;
          places.components = k == 0 ? 1 : 3;
          places.type = AttributeType::Double;
          places.values.clear();
          for (const Vec3& p : s.bodies[k].shape.points)
          {
            for (int axis = 0; axis < places.components; ++axis)
            {
              places.values.push_back(p[axis]);
            }
          }
        }
      } },
    { "texture-coordinates-not-finite-and-huge",
      [](Stage& s)
      {
        covered(s);
        for (Body& body : s.bodies)
        {
          std::vector<double>& values = body.texture.coordinates.values;
          for (std::size_t k = 0; k < values.size(); k += 9)
          {
            values[k] = k % 3 == 0 ? std::numeric_limits<double>::quiet_NaN()
              : k % 2 == 0         ? std::numeric_limits<double>::infinity()
                                   : 0x1p60;
          }
        }
        s.bodies[1].texture.interpolated().wrapped(TextureWrap::MirroredRepeat);
      } },
    { "texture-samples-3-alpha-passes",
      [](Stage& s)
      {
        covered(s);
        s.samples = 3;
        s.hasAlpha = true;
        s.scene.ambientModel = lambent::AmbientModel::Scene;
        s.scene.twoSidedLighting = false;
        s.showDepth();
        s.showNormals();
      } },
    { "texture-many-small-bodies",
      [](Stage& s)
      {
        s.daylight();
        for (int k = 0; k < 40; ++k)
        {
          const Vec3 at(0.25 * (k % 8) - 1.0, 0.5 * (k / 8) - 1.0, 0.125 * (k % 3));
          Body& body = s.add(moved(box({ 0.09375, 0.1875, 0.125 }), at)).flat();
          if (k % 3 > 0)
          {
            body.cover(2 + k % 5, 3, 3, AttributeType::UInt8).interpolated();
          }
          enlarge(body.texture);
        }
      } },
  };
}
