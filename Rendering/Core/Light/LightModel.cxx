// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LightModel.h"

#include "Elementary.h"

namespace lambent
{
LightSource::LightSource(const Light& light, const Vec3& eye)
  : positional(light.positional)
  , isConstant(true)
  , hasCone(light.positional && light.coneAngle < 90.0)
  , toLight(light.positional ? light.position - eye : -light.direction)
  , axis(0.0)
  , color(light.color)
  , coneCosine(0.0)
  , exponent(light.exponent)
  , attenuation(light.attenuation)
{
  if (this->hasCone)
  {
    this->axis = normalized(light.direction);
    this->coneCosine = cosDegrees(light.coneAngle);
  }
  const bool isAttenuated = light.positional && light.attenuation != Vec3(1.0, 0.0, 0.0);
  this->isConstant = !this->hasCone && !isAttenuated;
}

LightModel::LightModel(const Scene& scene, const Vec3& eye)
  : Ambient(scene.ambientModel)
{
  for (const Light& light : scene.lights)
  {
    this->Sources.emplace_back(light, eye);
  }
}

Vec3 LightModel::color(const SurfacePoint& point) const
{
  const Vec3& diffuse = point.color.diffuse;
  const Vec3& ambient = point.color.ambient;
  if (point.color.isUnlit)
  {
    return diffuse;
  }
  const double normalSquare = dot(point.normal, point.normal);
  Vec3 sum = this->Ambient == AmbientModel::Scene ? ambient : Vec3(0.0);
  for (const LightSource& source : this->Sources)
  {
    const Vec3 s = source.positional ? source.toLight - point.position : source.toLight;
    const double square = dot(s, s);
    const Vec3 light =
      source.isConstant ? source.color : source.color * arriving(source, s, std::sqrt(square));
    const double facing = dot(s, point.normal);
    Vec3 reflected(0.0);
    if (facing > 0.0)
    {
      reflected = (diffuse * light) * (facing / std::sqrt(square * normalSquare));
    }
    if (this->Ambient == AmbientModel::PerLight)
    {
      reflected = reflected + ambient * light;
    }
    sum = sum + reflected;
  }
  return sum;
}

double LightModel::arriving(const LightSource& source, const Vec3& toLight, double distance)
{
  if (!(distance > 0.0))
  {
    return 1.0;
  }
  const Vec3& a = source.attenuation;
  const double fraction = 1.0 / ((a.x + a.y * distance) + (a.z * distance) * distance);
  if (!source.hasCone)
  {
    return fraction;
  }
  const double cosine = -dot(toLight, source.axis) / distance;
  return cosine >= source.coneCosine ? fraction * power(cosine, source.exponent) : 0.0;
}
}
