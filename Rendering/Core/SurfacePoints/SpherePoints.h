// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief surface points of spheres
 *
 * The normal is the vector from the centre to the hit, with flat as with smooth shading. Two-sided
 * lighting turns it where the inside of the sphere is seen.
 *
 * An attribute of points has the value of the centre all over the sphere. A sphere has no
 * attributes of cells.
 *
 * SpherePoints::at() is the definition; VectorSpherePoints.h does the same for many hits.
 */
#ifndef lambent_SpherePoints_h
#define lambent_SpherePoints_h

#include "FrameMesh.h"
#include "SurfacePoint.h"

namespace lambent
{
class SpherePoints
{
public:
  SpherePoints(const FrameMesh& mesh, bool isTwoSided)
    : Mesh(mesh)
    , TwoSided(isTwoSided)
  {
  }

  /// The surface point where the ray through (x, y) hits a sphere of a part.
  SurfacePoint at(const SceneMesh::Part& part, std::uint32_t sphere, double x, double y) const;

  /// A component of an attribute of a sphere. NaN if the surface has no such attribute.
  static double attribute(
    const SceneMesh::Part& part, std::uint32_t sphere, std::size_t attribute, int component);

  const FrameMesh& mesh() const { return this->Mesh; }
  bool isTwoSided() const { return this->TwoSided; }

private:
  const FrameMesh& Mesh;
  bool TwoSided;
};

/// Calls store(valueOf), where valueOf(place, k) is component k of an attribute of points at a
/// place of the sphere. The same as SpherePoints::attribute().
template <typename Store>
void visitSphereAttribute(const AttributeSpan& values, const SceneMesh::Part& part,
  std::uint32_t number, const Store& store)
{
  const std::size_t first = static_cast<std::size_t>(values.components) * part.sphereOf(number);
  values.visit(
    [&](const auto* all)
    {
      const auto* const center = all + first;
      store([center](int, int k) { return static_cast<double>(center[k]); });
    });
}
}

#endif
