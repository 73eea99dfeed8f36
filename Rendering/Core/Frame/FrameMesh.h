// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the scene's primitives in the camera's frame, and exact hits of single rays
 *
 * Each kind of primitive has a struct with isHit(x, y, depth): whether the ray through (x, y) hits
 * it, and at which depth. visit() gives the struct of any primitive. The exact path of casting asks
 * nothing else.
 */
#ifndef lambent_FrameMesh_h
#define lambent_FrameMesh_h

#include "CameraFrame.h"
#include "LineContract.h"
#include "SceneMesh.h"

namespace lambent
{
struct FrameTriangle
{
  FramePoint a, b, c;
  const Appearance& appearance;

  /// intersect(), without hits on culled sides.
  bool isHit(double x, double y, Hit& hit) const
  {
    return intersect(this->a, this->b, this->c, x, y, hit) && !this->appearance.isCulled(hit.sum);
  }
  bool isHit(double x, double y, double& depth) const
  {
    Hit hit{};
    const bool isHit = this->isHit(x, y, hit);
    depth = hit.depth;
    return isHit;
  }
};

struct FrameSphere
{
  Sphere sphere;
  bool parallel;

  bool isHit(double x, double y, SphereHit& hit) const
  {
    return intersectSphere(this->sphere, x, y, this->parallel, hit);
  }
  bool isHit(double x, double y, double& depth) const
  {
    SphereHit hit{};
    const bool isHit = this->isHit(x, y, hit);
    depth = hit.depth;
    return isHit;
  }
};

struct FrameLine
{
  Line line;
  bool isDrawn; ///< false: there is no line to hit

  bool isHit(double x, double y, LineHit& hit) const
  {
    return this->isDrawn && intersectLine(this->line, x, y, hit);
  }
  bool isHit(double x, double y, double& depth) const
  {
    LineHit hit{};
    const bool isHit = this->isHit(x, y, hit);
    depth = hit.depth;
    return isHit;
  }
};

class FrameMesh
{
public:
  FrameMesh(const SceneMesh& mesh, const CameraFrame& frame)
    : Mesh(mesh)
    , Frame(frame)
  {
  }

  const SceneMesh& mesh() const { return this->Mesh; }
  const CameraFrame& frame() const { return this->Frame; }

  FrameTriangle triangle(std::uint32_t number) const
  {
    return this->triangle(this->Mesh.partOf(number), number);
  }
  FrameTriangle triangle(const SceneMesh::Part& part, std::uint32_t number) const
  {
    const std::size_t first = 3 * (number - part.firstPrimitive);
    const auto corner = [&](std::size_t k)
    { return this->Frame.toFrame(part.points()[part.corners()[first + k]]); };
    return { corner(0), corner(1), corner(2), *part.appearance };
  }

  FrameSphere sphere(const SceneMesh::Part& part, std::uint32_t number) const
  {
    const std::size_t point = part.sphereOf(number);
    const FramePoint center = this->Frame.toFrame(part.points()[point]);
    return { { center.x, center.y, center.z, part.surface->radiusOf(point), part.hasOutside(number),
               part.hasInside(number) },
      this->Frame.parallel };
  }

  FrameLine line(const SceneMesh::Part& part, std::uint32_t number) const
  {
    const std::size_t first = 2 * (number - part.firstPrimitive);
    const auto end = [&](std::size_t k)
    { return this->Frame.toFrame(part.points()[part.corners()[first + k]]); };
    FrameLine result{};
    result.isDrawn = projectLine(
      end(0), end(1), this->Frame.halfOf(part.surface->width), this->Frame.parallel, result.line);
    return result;
  }

  /// Returns body(primitive), where the primitive is a struct of its kind, see above.
  template <typename Body>
  auto visit(std::uint32_t number, const Body& body) const
  {
    const SceneMesh::Part& part = this->Mesh.partOf(number);
    return part.kind() == PrimitiveKind::Triangle ? body(this->triangle(part, number))
      : part.kind() == PrimitiveKind::Sphere      ? body(this->sphere(part, number))
                                                  : body(this->line(part, number));
  }

  /// Whether the ray through (x, y) hits a primitive, and at which depth.
  bool hits(std::uint32_t number, double x, double y, double& depth) const
  {
    return this->visit(number, [&](const auto& primitive) { return primitive.isHit(x, y, depth); });
  }

private:
  const SceneMesh& Mesh;
  const CameraFrame& Frame;
};
}

#endif
