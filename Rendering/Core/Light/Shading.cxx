// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shading.h"

#include "Elementary.h"

namespace lambent
{
Shader::Shader(const Scene& scene, const FrameMesh& mesh)
  : Mesh(mesh)
  , Ambient(scene.ambientModel)
  , TwoSided(scene.twoSidedLighting)
{
  for (const Light& light : scene.lights)
  {
    this->Sources.emplace_back(light, mesh.frame().eye);
  }
}

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

Vec3 Shader::color(std::uint32_t number, double x, double y) const
{
  const SceneMesh::Part& part = this->Mesh.mesh().partOf(number);
  const Surface& surface = *part.surface;
  if (surface.material.shading == Shading::Unlit)
  {
    return surface.material.color;
  }
  const std::size_t triangle = number - part.firstTriangle;
  Hit hit{};
  this->Mesh.triangle(number).isHit(x, y, hit);
  return this->lit(
    surface.material, this->frame().fromEye(x, y, hit.depth), this->normal(surface, triangle, hit));
}

Vec3 Shader::normal(const Surface& surface, std::size_t triangle, const Hit& hit) const
{
  const bool isBack = hit.sum < 0.0;
  const bool isTurned = this->TwoSided && isReversed(surface, triangle);
  const auto turned = [isTurned](const Vec3& m) { return isTurned ? -m : m; };
  if (surface.isSmooth())
  {
    const auto normal = [&](std::size_t corner)
    { return turned(surface.pointNormals[surface.normalsOfCorners()[3 * triangle + corner]]); };
    // Turned already on the back.
    const Vec3 m = (normal(0) * hit.e0 + normal(1) * hit.e1) + normal(2) * hit.e2;
    return isBack && !this->TwoSided ? -m : m;
  }
  const Vec3 m = turned(faceNormal(surface, triangle));
  return isBack && this->TwoSided ? -m : m;
}

bool Shader::isReversed(const Surface& surface, std::size_t triangle)
{
  const auto point = [&](std::size_t corner)
  { return surface.points[surface.corners[3 * triangle + corner]]; };
  const auto normal = [&](std::size_t corner)
  { return surface.pointNormals[surface.normalsOfCorners()[3 * triangle + corner]]; };
  const Vec3 given =
    surface.isSmooth() ? (normal(0) + normal(1)) + normal(2) : faceNormal(surface, triangle);
  return dot(cross(point(1) - point(0), point(2) - point(0)), given) < 0.0;
}

Vec3 Shader::faceNormal(const Surface& surface, std::size_t triangle)
{
  if (surface.cellNormals)
  {
    return surface.cellNormals[surface.cellOf(triangle)];
  }
  const Vec3 a = surface.points[surface.corners[3 * triangle]];
  const Vec3 b = surface.points[surface.corners[3 * triangle + 1]];
  const Vec3 c = surface.points[surface.corners[3 * triangle + 2]];
  return cross(b - a, c - a);
}

Vec3 Shader::lit(const Material& material, const Vec3& point, const Vec3& normal) const
{
  const double normalSquare = dot(normal, normal);
  Vec3 sum = this->Ambient == AmbientModel::Scene ? material.ambient : Vec3(0.0);
  for (const LightSource& source : this->Sources)
  {
    const Vec3 s = source.positional ? source.toLight - point : source.toLight;
    const double square = dot(s, s);
    const Vec3 light =
      source.isConstant ? source.color : source.color * arriving(source, s, std::sqrt(square));
    const double facing = dot(s, normal);
    Vec3 reflected(0.0);
    if (facing > 0.0)
    {
      reflected = (material.diffuse * light) * (facing / std::sqrt(square * normalSquare));
    }
    if (this->Ambient == AmbientModel::PerLight)
    {
      reflected = reflected + material.ambient * light;
    }
    sum = sum + reflected;
  }
  return sum;
}

double Shader::arriving(const LightSource& source, const Vec3& toLight, double distance)
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
