// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a surface: its geometry, attributes, appearance and origin
 */
#ifndef lambent_Surface_h
#define lambent_Surface_h

#include "Arithmetic.h"
#include "AttributeSpan.h"
#include "ColorArray.h"
#include "Spans.h"
#include "Texture.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace lambent
{
/// The number that means "no primitive". A scene must have fewer primitives than that.
constexpr std::uint32_t noPrimitive = 0xFFFFFFFFu;

/// What the primitives of a surface are, all of one kind.
enum class PrimitiveKind : unsigned char
{
  Triangle,
  Sphere,
  Line ///< of a width in pixels; one of length 0 is a point
};

enum class Shading
{
  Smooth, ///< interpolated point normals; flat if the surface has none
  Flat,   ///< cell normals; the triangle's own if the surface has none
  Unlit   ///< the plain colour
};

/// Lines along the edges of cells (EdgeLines.h). Spheres have none.
struct EdgeStyle
{
  Vec3 color{ 0.0 };
  double opacity = 1.0; ///< 0: the colour of the surface, 1: that of the edges
  double width = 1.0;   ///< in pixels
  bool areVisible = false;

  bool isSameAs(const EdgeStyle& other) const
  {
    return std::memcmp(this, &other, 5 * sizeof(double)) == 0 &&
      this->areVisible == other.areVisible;
  }
};

static_assert(offsetof(EdgeStyle, areVisible) == 5 * sizeof(double), "isSameAs() compares them");

/// The specular reflection of a surface (LightModel.h).
struct SpecularStyle
{
  double coefficient = 0.0; ///< 0: none
  Vec3 color{ 1.0 };
  double power = 1.0; ///< the larger, the smaller the highlights

  bool isSameAs(const SpecularStyle& other) const
  {
    return std::memcmp(this, &other, sizeof(SpecularStyle)) == 0;
  }
  /// rho_s of the light model.
  Vec3 reflection() const { return this->color * this->coefficient; }
};

static_assert(sizeof(SpecularStyle) == 5 * sizeof(double), "isSameAs() compares them");

/// How a surface reflects light, and which sides of it are drawn.
struct Appearance
{
  double diffuse = 1.0, ambient = 0.0; ///< coefficients
  Vec3 diffuseColor{ 1.0 };            ///< also the colour of an unlit surface
  Vec3 ambientColor{ 1.0 };
  /// 1: opaque, 0: not drawn. The alpha of colours multiplies it.
  double opacity = 1.0;
  Shading shading = Shading::Smooth;
  bool cullFront = false; ///< front faces (counter-clockwise) are not drawn
  bool cullBack = false;  ///< back faces are not drawn
  EdgeStyle edges;
  SpecularStyle specular;

  /// Compares bits: 0 differs from -0.
  bool isSameAs(const Appearance& other) const
  {
    return std::memcmp(this, &other, 9 * sizeof(double)) == 0 && this->shading == other.shading &&
      this->cullFront == other.cullFront && this->cullBack == other.cullBack &&
      this->edges.isSameAs(other.edges) && this->specular.isSameAs(other.specular);
  }

  /// rho_d and rho_a of the light model.
  Vec3 diffuseReflection() const { return this->diffuseColor * this->diffuse; }
  Vec3 ambientReflection() const { return this->ambientColor * this->ambient; }

  /// Whether lights have highlights on the surface.
  bool isShiny() const
  {
    return this->specular.coefficient != 0.0 && this->shading != Shading::Unlit;
  }
  /// The specular reflection, or nullptr if there is none.
  const SpecularStyle* shine() const { return this->isShiny() ? &this->specular : nullptr; }
  bool isCulling() const { return this->cullFront || this->cullBack; }
  /// Whether a face is culled. sum is positive where its front is seen (Hit::sum).
  bool isCulled(double sum) const
  {
    return (this->cullFront && sum > 0.0) || (this->cullBack && sum < 0.0);
  }
};

static_assert(offsetof(Appearance, shading) == 9 * sizeof(double), "isSameAs() compares them");

/// A triangle mesh, in which triangle t has the corners 3t, 3t+1, 3t+2; or, if it has a radius,
/// spheres, in which sphere s has its centre at point s; or, if it has a width, lines, in which
/// line l has its ends at the corners 2l, 2l+1. Points on screen are lines with both ends at one
/// point.
struct Surface
{
  // Geometry.
  TupleSpan points;
  IndexSpan corners;   ///< not used by spheres
  double radius = 0.0; ///< of all spheres; 0: the surface has triangles
  ScalarSpan radii;    ///< one per point, each times `radius`; or none
  double width = 0.0;  ///< of all lines, in pixels of the image; 0: the surface has none

  // Attributes.
  TupleSpan pointNormals; ///< one per point, or none
  bool isRounded = false; ///< lines are lit as tubes, and points as spheres
  /// The number of each corner's normal in pointNormals, if corners at one point have different
  /// normals. If empty, a corner has the normal of its point. Not used by lines.
  IndexSpan normalNumbers;
  TupleSpan cellNormals; ///< one per cell, or none; not used by lines
  /// Which edges of each triangle are edges of its cell, for lines along them: bit k is the edge
  /// from corner k to the next one. If nullptr, all are. The triangles of a cell must be
  /// consecutive, or each group of them shows lines of its own.
  const unsigned char* cellEdges = nullptr;
  /// Data that passes of the image show. All surfaces have theirs in the same order.
  std::vector<AttributeSpan> attributes;

  Appearance appearance;
  /// Colours of points or cells, which replace the diffuse and the ambient colour, or nullptr.
  /// Spheres can only have those of their points.
  const ColorArray* colors = nullptr;
  /// The texture of triangles, or nullptr; spheres have none.
  const TextureMap* texture = nullptr;

  // Origin.
  /// The cell of each triangle or line. If nullptr, the cell is firstCell + primitive. A sphere has
  /// the number of its point instead.
  const std::int64_t* cells = nullptr;
  std::int64_t firstCell = 0;

  bool isSmooth() const
  {
    return this->appearance.shading == Shading::Smooth && this->pointNormals;
  }
  const IndexSpan& normalsOfCorners() const
  {
    return this->normalNumbers.data ? this->normalNumbers : this->corners;
  }
  /// An attribute by its index, or nullptr if the surface does not have it. Spheres belong to no
  /// cell, so they have no attributes of cells.
  const AttributeSpan* attribute(std::size_t index) const
  {
    const bool isThere = index < this->attributes.size() && this->attributes[index] &&
      !(this->kind() == PrimitiveKind::Sphere && this->attributes[index].isPerCell);
    return isThere ? &this->attributes[index] : nullptr;
  }
  PrimitiveKind kind() const
  {
    return this->radius > 0.0 ? PrimitiveKind::Sphere
      : this->width > 0.0     ? PrimitiveKind::Line
                              : PrimitiveKind::Triangle;
  }
  /// Of a triangle mesh.
  std::size_t triangleCount() const { return this->corners.size / 3; }
  bool hasTexture() const { return this->texture && this->kind() == PrimitiveKind::Triangle; }
  /// Whether something behind the surface may be seen through it.
  bool isTransparent() const
  {
    return this->appearance.opacity != 1.0 || (this->colors && this->colors->hasAlpha) ||
      (this->hasTexture() && this->texture->texture.hasAlpha);
  }
  /// A ray meets a sphere twice. Both sides are seen if it is transparent, so it has a primitive
  /// for each: sphere s has its outside at 2 s and its inside at 2 s + 1. An opaque sphere has one.
  std::size_t primitivesPerSphere() const { return this->isTransparent() ? 2 : 1; }
  double radiusOf(std::size_t sphere) const
  {
    return this->radii ? this->radius * this->radii[sphere] : this->radius;
  }
  /// The number of primitives of the surface.
  std::size_t primitiveCount() const
  {
    const PrimitiveKind kind = this->kind();
    return kind == PrimitiveKind::Sphere ? this->points.size * this->primitivesPerSphere()
                                         : this->corners.size / cornersOf(kind);
  }
  static std::size_t cornersOf(PrimitiveKind kind)
  {
    return kind == PrimitiveKind::Triangle ? 3 : kind == PrimitiveKind::Line ? 2 : 0;
  }

  /// Calls body(point) for points whose bounding box is that of the primitives [begin, end): the
  /// corners of triangles and lines, except those whose point does not exist; or opposite corners
  /// of the boxes around spheres.
  template <typename Body>
  void forBoundingPoints(std::size_t begin, std::size_t end, Body&& body) const
  {
    const PrimitiveKind kind = this->kind();
    for (std::size_t k = begin; kind == PrimitiveKind::Sphere && k < end; ++k)
    {
      const std::size_t sphere = k / this->primitivesPerSphere();
      const double size = this->radiusOf(sphere);
      body(this->points[sphere] - Vec3(size));
      body(this->points[sphere] + Vec3(size));
    }
    const std::size_t corners = cornersOf(kind);
    for (std::size_t corner = corners * begin; corner < corners * end; ++corner)
    {
      const std::uint64_t id = this->corners[corner];
      if (id < this->points.size)
      {
        body(this->points[id]);
      }
    }
  }
  /// The cell of a triangle or line, or the number of a sphere.
  std::int64_t cellOf(std::size_t primitive) const
  {
    const std::size_t place =
      this->kind() == PrimitiveKind::Sphere ? primitive / this->primitivesPerSphere() : primitive;
    return this->cells ? this->cells[place] : this->firstCell + static_cast<std::int64_t>(place);
  }
};
}

#endif
