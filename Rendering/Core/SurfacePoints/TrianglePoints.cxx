// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TrianglePoints.h"

#include "TextureFactors.h"

#include <limits>

namespace lambent
{
SurfacePoint TrianglePoints::at(std::uint32_t number, double x, double y) const
{
  const SceneMesh::Part& part = this->Mesh.mesh().partOf(number);
  Hit hit{};
  this->Mesh.triangle(number).isHit(x, y, hit);
  const std::size_t triangle = number - part.firstPrimitive;
  const Vec3 weights(hit.e0 / hit.sum, hit.e1 / hit.sum, hit.e2 / hit.sum);
  return { this->Mesh.frame().fromEye(x, y, hit.depth), hit.depth,
    this->normal(*part.surface, triangle, hit), weights,
    this->color(*part.surface, triangle, weights),
    part.hasTexture() ? textureAt(*part.surface, triangle, weights) : TextureColor() };
}

SurfaceColor TrianglePoints::color(
  const Surface& surface, std::size_t triangle, const Vec3& weights) const
{
  const ColorArray* const colors = surface.colors;
  if (!colors || colors->values.isPerCell)
  {
    return colorOf(surface, triangle);
  }
  const auto point = [&](std::size_t corner) { return surface.corners[3 * triangle + corner]; };
  if (colors->isMappedLast)
  {
    const double number =
      (colors->number(point(0)) * weights.x + colors->number(point(1)) * weights.y) +
      colors->number(point(2)) * weights.z;
    return colorOf(surface.appearance, colors->table->color(number),
      colors->hasAlpha ? colors->table->alpha(number) : 1.0);
  }
  const double alpha = colors->hasAlpha
    ? (colors->alpha(point(0)) * weights.x + colors->alpha(point(1)) * weights.y) +
      colors->alpha(point(2)) * weights.z
    : 1.0;
  return colorOf(surface.appearance,
    (colors->color(point(0)) * weights.x + colors->color(point(1)) * weights.y) +
      colors->color(point(2)) * weights.z,
    alpha);
}

double TrianglePoints::attribute(
  std::uint32_t number, const Vec3& weights, std::size_t attribute, int component) const
{
  const SceneMesh::Part& part = this->Mesh.mesh().partOf(number);
  const Surface& surface = *part.surface;
  const std::size_t triangle = number - part.firstPrimitive;
  const AttributeSpan* const found = surface.attribute(attribute);
  if (!found)
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const AttributeSpan& values = *found;
  if (values.isPerCell)
  {
    return values.at(static_cast<std::size_t>(surface.cellOf(triangle)), component);
  }
  const auto at = [&](std::size_t corner)
  { return values.at(surface.corners[3 * triangle + corner], component); };
  return (at(0) * weights.x + at(1) * weights.y) + at(2) * weights.z;
}

Vec3 TrianglePoints::normal(const Surface& surface, std::size_t triangle, const Hit& hit) const
{
  const bool isBack = hit.sum < 0.0;
  const bool isTurned = this->TwoSided && isReversed(surface, triangle);
  const auto turned = [isTurned](const Vec3& m) { return isTurned ? -m : m; };
  if (surface.isSmooth())
  {
    const auto normal = [&](std::size_t corner)
    { return turned(surface.pointNormals[surface.normalsOfCorners()[3 * triangle + corner]]); };
    // On the back the edge functions are negative, which turns m.
    const Vec3 m = (normal(0) * hit.e0 + normal(1) * hit.e1) + normal(2) * hit.e2;
    return isBack && !this->TwoSided ? -m : m;
  }
  const Vec3 m = turned(faceNormal(surface, triangle));
  return isBack && this->TwoSided ? -m : m;
}

bool TrianglePoints::isReversed(const Surface& surface, std::size_t triangle)
{
  const auto point = [&](std::size_t corner)
  { return surface.points[surface.corners[3 * triangle + corner]]; };
  const auto normal = [&](std::size_t corner)
  { return surface.pointNormals[surface.normalsOfCorners()[3 * triangle + corner]]; };
  const Vec3 given =
    surface.isSmooth() ? (normal(0) + normal(1)) + normal(2) : faceNormal(surface, triangle);
  return dot(cross(point(1) - point(0), point(2) - point(0)), given) < 0.0;
}

Vec3 TrianglePoints::faceNormal(const Surface& surface, std::size_t triangle)
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
}
