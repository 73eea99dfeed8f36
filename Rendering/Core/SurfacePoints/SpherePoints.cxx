// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SpherePoints.h"

#include <limits>

namespace lambent
{
SurfacePoint SpherePoints::at(
  const SceneMesh::Part& part, std::uint32_t number, double x, double y) const
{
  SphereHit hit{};
  this->Mesh.sphere(part, number).isHit(x, y, hit);
  const CameraFrame& frame = this->Mesh.frame();
  const Vec3 position = frame.fromEye(x, y, hit.depth);
  const Vec3 center = part.points()[part.sphereOf(number)] - frame.eye;
  const Vec3 normal = position - center;
  return { position, hit.depth, hit.isInside && this->TwoSided ? -normal : normal,
    { 1.0, 0.0, 0.0 }, colorOf(*part.surface, number - part.firstPrimitive) };
}

double SpherePoints::attribute(
  const SceneMesh::Part& part, std::uint32_t number, std::size_t attribute, int component)
{
  const AttributeSpan* const values = part.surface->attribute(attribute);
  return values ? values->at(part.sphereOf(number), component)
                : std::numeric_limits<double>::quiet_NaN();
}
}
