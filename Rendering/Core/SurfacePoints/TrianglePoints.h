// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief surface points of triangles
 *
 * Smooth shading interpolates the three point normals by the edge functions themselves, which
 * are the barycentric coordinates but for a factor: the light model takes normals of any
 * length. That factor is negative on the back of a face, where two-sided lighting turns the
 * normal anyway.
 *
 * Two-sided lighting turns the normal to the viewer. The front of a triangle is where its
 * corners run counter-clockwise, or the other side where its normals lie there (isReversed()):
 * in a mirrored mesh the faces run the wrong way round while the normals still point outward.
 * It is judged once for the whole triangle, so that no seam runs through it.
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

  /// Where the ray through (x, y) hits a triangle.
  SurfacePoint at(std::uint32_t triangle, double x, double y) const;

  /// The normal of the face: the cell's, if the surface has some.
  static Vec3 faceNormal(const Surface& surface, std::size_t triangle);

  /// Whether the sum of the triangle's three point normals (or the face's normal where it is
  /// shaded flat) lies on the other side than its winding says is its front.
  static bool isReversed(const Surface& surface, std::size_t triangle);

  const FrameMesh& mesh() const { return this->Mesh; }
  bool isTwoSided() const { return this->TwoSided; }

private:
  Vec3 normal(const Surface& surface, std::size_t triangle, const Hit& hit) const;

  const FrameMesh& Mesh;
  bool TwoSided;
};
}

#endif
