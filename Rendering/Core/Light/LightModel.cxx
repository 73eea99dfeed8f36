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
  , specularColor(light.specularColor)
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
  , Parallel(scene.camera.parallel)
  , TowardsViewer(-normalized(scene.camera.focalPoint - scene.camera.position))
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
  return point.color.specular ? sum + this->highlights(point, *point.color.specular) : sum;
}

Vec3 LightModel::highlights(const SurfacePoint& point, const SpecularStyle& style) const
{
  const Vec3& m = point.normal;
  const Vec3 v = this->Parallel ? this->TowardsViewer : -point.position;
  const double normalSquare = dot(m, m), viewSquare = dot(v, v);
  const Vec3 reflection = style.reflection();
  Vec3 sum(0.0);
  for (const LightSource& source : this->Sources)
  {
    const Vec3 s = source.positional ? source.toLight - point.position : source.toLight;
    const double facing = dot(s, m);
    if (facing > 0.0)
    {
      const double square = dot(s, s);
      const Vec3 light = source.isConstant
        ? source.specularColor
        : source.specularColor * arriving(source, s, std::sqrt(square));
      const double mirrored = ((2.0 * facing) / normalSquare) * dot(m, v) - dot(s, v);
      const double cosine = mirrored / std::sqrt(square * viewSquare);
      sum = sum + (reflection * light) * power(cosine > 0.0 ? cosine : 0.0, style.power);
    }
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
