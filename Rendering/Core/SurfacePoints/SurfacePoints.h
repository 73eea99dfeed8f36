// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the surface points of a scene, whatever kind of primitive a ray hits
 *
 * Painting, light and passes ask here and do not know the kinds. Each kind has a class with a
 * definition for single hits (TrianglePoints.h, SpherePoints.h, LinePoints.h). Triangles and
 * spheres have a twin for several hits at a time (VectorTrianglePoints.h, VectorSpherePoints.h,
 * chosen in VectorSurfacePoints.h).
 */
#ifndef lambent_SurfacePoints_h
#define lambent_SurfacePoints_h

#include "CornerAttribute.h"
#include "LinePoints.h"
#include "SpherePoints.h"
#include "TrianglePoints.h"

namespace lambent
{
class SurfacePoints
{
public:
  SurfacePoints(const FrameMesh& mesh, bool isTwoSided)
    : Triangles(mesh, isTwoSided)
    , Spheres(mesh, isTwoSided)
    , Lines(mesh)
  {
  }

  /// The surface point where the ray through (x, y) hits a primitive.
  SurfacePoint at(std::uint32_t primitive, double x, double y) const
  {
    const SceneMesh::Part& part = this->mesh().partOf(primitive);
    return part.kind() == PrimitiveKind::Triangle ? this->Triangles.at(primitive, x, y)
      : part.kind() == PrimitiveKind::Sphere      ? this->Spheres.at(part, primitive, x, y)
                                                  : this->Lines.at(part, primitive, x, y);
  }

  /// A component of an attribute at a surface point with these weights: the value of the cell, or
  /// that of the points, interpolated; that of the centre of a sphere. NaN if the surface has no
  /// such attribute.
  double attribute(
    std::uint32_t primitive, const Vec3& weights, std::size_t attribute, int component) const
  {
    const SceneMesh::Part& part = this->mesh().partOf(primitive);
    return part.kind() == PrimitiveKind::Triangle
      ? this->Triangles.attribute(primitive, weights, attribute, component)
      : part.kind() == PrimitiveKind::Sphere
      ? SpherePoints::attribute(part, primitive, attribute, component)
      : LinePoints::attribute(part, primitive, weights, attribute, component);
  }

  /// Calls store(valueOf), where valueOf(place, k) is component k of an attribute at a place of the
  /// batch. All places are on one primitive. The values are those of attribute().
  template <typename Store>
  void visitAttribute(const AttributeSpan& values, const SceneMesh::Part& part,
    std::uint32_t primitive, const PointBatch& points, const Store& store) const
  {
    part.kind() == PrimitiveKind::Triangle
      ? visitCornerAttribute<3>(values, part, primitive, points, store)
      : part.kind() == PrimitiveKind::Sphere
      ? visitSphereAttribute(values, part, primitive, store)
      : visitCornerAttribute<2>(values, part, primitive, points, store);
  }

  const SceneMesh& mesh() const { return this->Triangles.mesh().mesh(); }
  const Vec3& eye() const { return this->Triangles.mesh().frame().eye; }
  const TrianglePoints& triangles() const { return this->Triangles; }
  const SpherePoints& spheres() const { return this->Spheres; }
  const LinePoints& lines() const { return this->Lines; }

private:
  const TrianglePoints Triangles;
  const SpherePoints Spheres;
  const LinePoints Lines;
};
}

#endif
