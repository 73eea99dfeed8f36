// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shading.h"

#include "Elementary.h"

namespace lambent
{
Shader::Shader(const Scene& scene, const Mesh& mesh, const CameraFrame& frame)
  : Triangles(mesh)
  , Frame(frame)
  , Ambient(scene.ambientModel)
  , TwoSided(scene.twoSidedLighting)
{
  for (const Light& light : scene.lights)
  {
    this->Sources.push_back(makeSource(light, frame.eye));
  }
}

Shader::Source Shader::makeSource(const Light& light, const Vec3& eye)
{
  const bool hasCone = light.positional && light.coneAngle < 90.0;
  const bool isAttenuated = light.positional && light.attenuation != Vec3(1.0, 0.0, 0.0);
  return { light.positional, !hasCone && !isAttenuated, hasCone,
    light.positional ? light.position - eye : -light.direction,
    hasCone ? normalized(light.direction) : Vec3(0.0), light.color,
    hasCone ? cosDegrees(light.coneAngle) : 0.0, light.exponent, light.attenuation };
}

Vec3 Shader::color(std::uint32_t number, double x, double y) const
{
  const Mesh::Part& part = this->Triangles.partOf(number);
  const Surface& surface = *part.surface;
  if (surface.material.shading == Shading::Unlit)
  {
    return surface.material.color;
  }
  const std::size_t triangle = number - part.firstTriangle;
  const auto corner = [&](std::size_t k) {
    return this->Frame.toFrame(surface.points[surface.corners[3 * triangle + k]]);
  };
  Hit hit{};
  intersect(corner(0), corner(1), corner(2), x, y, hit);
  Vec3 m = this->normal(surface, triangle, hit);
  if (this->TwoSided && hit.sum < 0.0)
  {
    m = -m;
  }
  return this->lit(surface.material, this->Frame.fromEye(x, y, hit.depth), m);
}

Vec3 Shader::normal(const Surface& surface, std::size_t triangle, const Hit& hit) const
{
  const std::size_t corners[3] = { surface.corners[3 * triangle],
    surface.corners[3 * triangle + 1], surface.corners[3 * triangle + 2] };
  if (surface.material.shading == Shading::Smooth && surface.pointNormals)
  {
    const Vec3 a = surface.pointNormals[corners[0]];
    const Vec3 b = surface.pointNormals[corners[1]];
    const Vec3 c = surface.pointNormals[corners[2]];
    return (a * (hit.e0 / hit.sum) + b * (hit.e1 / hit.sum)) + c * (hit.e2 / hit.sum);
  }
  if (surface.cellNormals)
  {
    return surface.cellNormals[surface.cellOf(triangle)];
  }
  const Vec3 a = surface.points[corners[0]];
  return cross(surface.points[corners[1]] - a, surface.points[corners[2]] - a);
}

Vec3 Shader::lit(const Material& material, const Vec3& point, const Vec3& normal) const
{
  const double normalLength = length(normal);
  Vec3 sum = this->Ambient == AmbientModel::Scene ? material.ambient : Vec3(0.0);
  for (const Source& source : this->Sources)
  {
    const Vec3 s = source.positional ? source.toLight - point : source.toLight;
    const double distance = length(s);
    const Vec3 light =
      source.isConstant ? source.color : source.color * arriving(source, s, distance);
    const double facing = dot(s, normal);
    Vec3 reflected(0.0);
    if (facing > 0.0)
    {
      reflected = (material.diffuse * light) * (facing / (distance * normalLength));
    }
    if (this->Ambient == AmbientModel::PerLight)
    {
      reflected = reflected + material.ambient * light;
    }
    sum = sum + reflected;
  }
  return sum;
}

double Shader::arriving(const Source& source, const Vec3& toLight, double distance)
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
