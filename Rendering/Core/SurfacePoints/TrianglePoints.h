// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief surface points of triangles
 *
 * Smooth shading interpolates the three point normals with the edge functions, which are the
 * barycentric coordinates times a common factor. The light model accepts normals of any length. The
 * factor is negative on the back of a face, where two-sided lighting turns the normal anyway.
 *
 * Two-sided lighting turns the normal towards the viewer. The front of a triangle is the side from
 * which its corners run counter-clockwise, unless its normals lie on the other side (isReversed());
 * then that side is the front. In a mirrored mesh the faces are wound the wrong way while the
 * normals still point outward. The front is determined once per triangle, so that no seam runs
 * through it.
 *
 * TrianglePoints::at() is the definition; VectorTrianglePoints.h does the same for many hits.
 */
#ifndef lambent_TrianglePoints_h
#define lambent_TrianglePoints_h

#include "FrameMesh.h"
#include "SurfacePoint.h"

namespace lambent
{
class TrianglePoints
{
public:
  TrianglePoints(const FrameMesh& mesh, bool isTwoSided)
    : Mesh(mesh)
    , TwoSided(isTwoSided)
  {
  }

  /// The surface point where the ray through (x, y) hits a triangle.
  SurfacePoint at(std::uint32_t triangle, double x, double y) const;

  /// A component of an attribute at a surface point with these weights: the value of the cell, or
  /// that of the points, interpolated. NaN if the surface has no such attribute.
  double attribute(
    std::uint32_t triangle, const Vec3& weights, std::size_t attribute, int component) const;

  /// The face normal: the cell normal if the surface has cell normals, else that of the geometry.
  static Vec3 faceNormal(const Surface& surface, std::size_t triangle);

  /// Whether the normals lie on the other side of the triangle than the front that its winding
  /// defines. With smooth shading, the sum of the three point normals counts, otherwise the face
  /// normal.
  static bool isReversed(const Surface& surface, std::size_t triangle);

  const FrameMesh& mesh() const { return this->Mesh; }
  bool isTwoSided() const { return this->TwoSided; }

private:
  SurfaceColor color(const Surface& surface, std::size_t triangle, const Vec3& weights) const;
  Vec3 normal(const Surface& surface, std::size_t triangle, const Hit& hit) const;

  const FrameMesh& Mesh;
  bool TwoSided;
};
}

#endif
