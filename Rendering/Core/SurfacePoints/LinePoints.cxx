// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LinePoints.h"

#include <limits>

namespace lambent
{
namespace
{
/// The colour of a surface that has colours of points, or one for each cell, or none.
SurfaceColor colorAt(const Surface& surface, std::size_t line, const Vec3& weights)
{
  const ColorArray* const colors = surface.colors;
  if (!colors || colors->values.isPerCell)
  {
    return colorOf(surface, line);
  }
  const std::uint64_t a = surface.corners[2 * line], b = surface.corners[2 * line + 1];
  return colorOf(surface.appearance,
    colors->isMappedLast
      ? colors->table->color(colors->number(a) * weights.x + colors->number(b) * weights.y)
      : colors->color(a) * weights.x + colors->color(b) * weights.y);
}

/// The unit vector perpendicular to a line, in its plane with the ray, towards the viewer. If the
/// line has no length or points at the eye, the one against the ray. `ray` has length 1.
Vec3 perpendicular(const Vec3& along, const Vec3& ray)
{
  constexpr double smallestSine = 1.0 / (std::int64_t(1) << 40);
  if (!(dot(along, along) > 0.0))
  {
    return -ray;
  }
  const Vec3 direction = normalized(along);
  const Vec3 across = direction * dot(ray, direction) - ray;
  return length(across) > smallestSine ? normalized(across) : -ray;
}
}

SurfacePoint LinePoints::at(const SceneMesh::Part& part, std::uint32_t number,
  const FrameLine& line, double x, double y) const
{
  LineHit hit{};
  line.isHit(x, y, hit);
  const CameraFrame& frame = this->Mesh.frame();
  const Vec3 position = frame.fromEye(x, y, hit.depth);
  const Vec3 ray = frame.parallel ? frame.forward : normalized(frame.fromEye(x, y, 1.0));
  const Vec3 weights(hit.a, hit.b, 0.0);
  const std::size_t place = number - part.firstPrimitive;
  return { position, hit.depth, this->normal(*part.surface, place, hit, ray), weights,
    colorAt(*part.surface, place, weights) };
}

Vec3 LinePoints::normal(
  const Surface& surface, std::size_t line, const LineHit& hit, const Vec3& ray) const
{
  const std::uint64_t a = surface.corners[2 * line], b = surface.corners[2 * line + 1];
  if (surface.isSmooth() && !surface.isRounded)
  {
    const Vec3 m = surface.pointNormals[a] * hit.a + surface.pointNormals[b] * hit.b;
    return dot(m, ray) > 0.0 ? -m : m;
  }
  const Vec3 towards = perpendicular(surface.points[b] - surface.points[a], ray);
  if (!surface.isRounded)
  {
    return towards;
  }
  const CameraFrame& frame = this->Mesh.frame();
  const Vec3 offset = frame.right * hit.u + frame.up * hit.v;
  return (offset - ray * dot(offset, ray)) + towards * hit.rise;
}

double LinePoints::attribute(const SceneMesh::Part& part, std::uint32_t number, const Vec3& weights,
  std::size_t attribute, int component)
{
  const Surface& surface = *part.surface;
  const std::size_t line = number - part.firstPrimitive;
  const AttributeSpan* const values = surface.attribute(attribute);
  if (!values)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (values->isPerCell)
  {
    return values->at(static_cast<std::size_t>(surface.cellOf(line)), component);
  }
  return values->at(surface.corners[2 * line], component) * weights.x +
    values->at(surface.corners[2 * line + 1], component) * weights.y;
}
}
