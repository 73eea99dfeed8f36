// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
// The formula of highlights, compared with long double; vectors are mirrored there as the formula's
// words say.
#include "LightModel.h"
#include "RandomNumbers.h"

#include <gtest/gtest.h>

using namespace lambent;

namespace
{
using Long = long double;

struct LongVector
{
  Long x, y, z;
};

LongVector toLong(const Vec3& v)
{
  return { v.x, v.y, v.z };
}

Long product(const LongVector& a, const LongVector& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

LongVector unit(const LongVector& v)
{
  const Long length = std::sqrt(product(v, v));
  return { v.x / length, v.y / length, v.z / length };
}

/// A scene with two lights, and a point that they may reach.
struct LitPoint
{
  Scene scene;
  SurfacePoint point;
  SpecularStyle style;

  explicit LitPoint(RandomNumbers& random)
  {
    this->scene.camera.position = Vec3(0.0);
    this->scene.camera.focalPoint = random.inBox(1.0);
    this->scene.camera.parallel = random.below(2) == 0;
    Light light;
    light.direction = random.inBox(1.0);
    light.specularColor = random.inBox(0.5) + Vec3(0.5);
    this->scene.lights.push_back(light);
    light.positional = true;
    light.position = random.inBox(3.0);
    light.attenuation = { 0.5, 0.25, 0.125 };
    light.specularColor = random.inBox(0.5) + Vec3(0.5);
    this->scene.lights.push_back(light);
    this->point.position = random.inBox(2.0);
    this->point.normal = random.inBox(1.0) * random.within(0.1, 10.0);
    this->style = { 0.75, random.inBox(0.5) + Vec3(0.5), random.within(0.0, 40.0) };
    this->point.color = { false, Vec3(0.25), Vec3(0.125), 1.0, &this->style };
  }

  /// The brightness of a light's highlight, without colours.
  Long brightness(const Light& light) const
  {
    const Vec3& p = this->point.position;
    const LongVector toLight = light.positional ? LongVector{ Long(light.position.x) - p.x,
      Long(light.position.y) - p.y, Long(light.position.z) - p.z }
                                                : toLong(-light.direction);
    const LongVector s = unit(toLight), m = unit(toLong(this->point.normal));
    const Camera& camera = this->scene.camera;
    const LongVector v = unit(toLong(camera.parallel ? -camera.focalPoint : -p));
    const Long facing = product(s, m);
    const LongVector r{ 2 * facing * m.x - s.x, 2 * facing * m.y - s.y, 2 * facing * m.z - s.z };
    const Long distance = std::sqrt(product(toLight, toLight));
    const Long fraction =
      light.positional ? 1 / (0.5L + 0.25L * distance + 0.125L * distance * distance) : 1;
    return facing > 0
      ? fraction * std::pow(std::max(product(r, v), Long(0)), Long(this->style.power))
      : 0;
  }
};
}

TEST(SpecularLight, EqualsTheFormulaInLongDouble)
{
  RandomNumbers random(11);
  int bright = 0;
  for (int k = 0; k < 20000; ++k)
  {
    const LitPoint lit(random);
    const LightModel model(lit.scene, Vec3(0.0));
    const Vec3 found = model.highlights(lit.point, lit.style);
    for (int channel = 0; channel < 3; ++channel)
    {
      Long expected = 0;
      for (const Light& light : lit.scene.lights)
      {
        expected += Long(0.75) * lit.style.color[channel] * light.specularColor[channel] *
          lit.brightness(light);
      }
      EXPECT_NEAR(found[channel], static_cast<double>(expected), 1e-13);
      bright += expected > 0.01L ? 1 : 0;
    }
  }
  EXPECT_GT(bright, 3000);
}

TEST(SpecularLight, IsAddedToTheOtherTerms)
{
  RandomNumbers random(12);
  for (int k = 0; k < 1000; ++k)
  {
    LitPoint lit(random);
    const LightModel model(lit.scene, Vec3(0.0));
    const Vec3 all = model.color(lit.point);
    lit.point.color.specular = nullptr;
    EXPECT_EQ(all, model.color(lit.point) + model.highlights(lit.point, lit.style));
    lit.point.color.isUnlit = true;
    EXPECT_EQ(model.color(lit.point), lit.point.color.diffuse);
  }
}

TEST(SpecularLight, OfSurfacesThatReflectNoneIsNotComputed)
{
  Appearance appearance;
  EXPECT_EQ(colorOf(appearance).specular, nullptr);
  appearance.specular.coefficient = 0.5;
  EXPECT_EQ(colorOf(appearance).specular, &appearance.specular);
  EXPECT_EQ(colorOf(appearance, Vec3(0.5)).specular, &appearance.specular);
  appearance.shading = Shading::Unlit;
  EXPECT_EQ(colorOf(appearance).specular, nullptr);
}
