// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LinePoints.h"

#include <algorithm>
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
  if (colors->isMappedLast)
  {
    const double number = colors->number(a) * weights.x + colors->number(b) * weights.y;
    return colorOf(surface.appearance, colors->table->color(number),
      colors->hasAlpha ? colors->table->alpha(number) : 1.0);
  }
  return colorOf(surface.appearance, colors->color(a) * weights.x + colors->color(b) * weights.y,
    colors->hasAlpha ? colors->alpha(a) * weights.x + colors->alpha(b) * weights.y : 1.0);
}

/// A vector perpendicular to a line, in its plane with the ray, towards the viewer. If the line has
/// no length or points at the eye, the one against the ray. `ray` has length 1.
Vec3 perpendicular(const Vec3& along, const Vec3& ray)
{
  constexpr double smallestSine = 1.0 / (std::int64_t(1) << 40);
  const double square = dot(along, along);
  if (!(square > 0.0))
  {
    return -ray;
  }
  const Vec3 across = along * (dot(ray, along) / square) - ray;
  return dot(across, across) > smallestSine * smallestSine ? across : -ray;
}
}

SurfacePoint LinePoints::at(const SceneMesh::Part& part, std::uint32_t number,
  const FrameLine& line, double x, double y) const
{
  LineHit hit{};
  line.isHit(x, y, hit);
  const CameraFrame& frame = this->Mesh.frame();
  const Vec3 position = frame.fromEye(x, y, hit.depth);
  const Vec3 ray = frame.parallel ? frame.forward : normalized(position);
  const Vec3 weights(hit.a, hit.b, 0.0);
  const Surface& surface = *part.surface;
  const std::size_t place = number - part.firstPrimitive;
  const std::uint64_t a = surface.corners[2 * place], b = surface.corners[2 * place + 1];
  Vec3 normal;
  if (surface.isRounded)
  {
    normal = this->roundNormal(surface.points[b] - surface.points[a], line.line, hit, ray);
  }
  else if (surface.isSmooth())
  {
    const Vec3 m = surface.pointNormals[a] * hit.a + surface.pointNormals[b] * hit.b;
    normal = dot(m, ray) > 0.0 ? -m : m;
  }
  else
  {
    normal = perpendicular(surface.points[b] - surface.points[a], ray);
  }
  return { position, hit.depth, normal, weights, colorAt(surface, place, weights) };
}

Vec3 LinePoints::roundNormal(
  const Vec3& along, const Line& line, const LineHit& hit, const Vec3& ray) const
{
  const auto across = [&](double u, double v)
  {
    const Vec3 offset = this->Mesh.frame().right * u + this->Mesh.frame().up * v;
    return offset - ray * dot(offset, ray);
  };
  for (const double end : { 0.0, 1.0 }) // the nearer end first
  {
    const double u = hit.u + (hit.t - end) * line.dx, v = hit.v + (hit.t - end) * line.dy;
    const double square = u * u + v * v;
    if (square <= 1.0)
    {
      const Vec3 normal = across(u, v) - ray * std::sqrt(1.0 - square);
      const bool isFirst = (end == 0.0) != line.isTurned;
      if (!(dot(normal, isFirst ? -along : along) < 0.0))
      {
        return normal;
      }
    }
  }
  const double distance = (hit.u * line.dy - hit.v * line.dx) * line.perSquare;
  const double u = distance * line.dy, v = -distance * line.dx;
  return across(u, v) +
    normalized(perpendicular(along, ray)) * std::sqrt(std::max(0.0, 1.0 - (u * u + v * v)));
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
