// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief surface points of lines, and of points that are lines of length 0
 *
 * A line has no sides. Its normal always looks at the viewer, whatever two-sided lighting says:
 *
 * - With smooth shading, the normals of the ends are interpolated, and turned if they point away.
 * - Otherwise the normal is perpendicular to the line, in the plane of the line and the ray. A line
 *   that points at the eye, and a point, look along the ray.
 * - If the surface is rounded (Surface::isRounded), its normal is that of a tube around the line
 *   with half a sphere at each end: of the sphere, where that lies beyond the end; else across the
 *   line by the distance from the centre line, and the rest towards the viewer.
 *
 * Attributes are interpolated along the line, with the share of the second end as its weight. The
 * third weight is 0.
 *
 * LinePoints::at() is the definition. Lines cover few samples each, so that their batches are
 * shaded with it, too (LineBatch.h).
 */
#ifndef lambent_LinePoints_h
#define lambent_LinePoints_h

#include "FrameMesh.h"
#include "SurfacePoint.h"

namespace lambent
{
class LinePoints
{
public:
  explicit LinePoints(const FrameMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// The surface point where the ray through (x, y) hits a line of a part.
  SurfacePoint at(const SceneMesh::Part& part, std::uint32_t line, double x, double y) const
  {
    return this->at(part, line, this->Mesh.line(part, line), x, y);
  }
  /// The same, for a line that is known in the frame.
  SurfacePoint at(const SceneMesh::Part& part, std::uint32_t number, const FrameLine& line,
    double x, double y) const;

  /// A component of an attribute at a surface point with these weights. NaN if the surface has no
  /// such attribute.
  static double attribute(const SceneMesh::Part& part, std::uint32_t line, const Vec3& weights,
    std::size_t attribute, int component);

  const FrameMesh& mesh() const { return this->Mesh; }

private:
  Vec3 roundNormal(const Vec3& along, const Line& line, const LineHit& hit, const Vec3& ray) const;

  const FrameMesh& Mesh;
};
}

#endif
