// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a surface: its geometry, its attributes, its appearance, and where it comes from
 */
#ifndef lambent_Surface_h
#define lambent_Surface_h

#include "Arithmetic.h"
#include "Spans.h"

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace lambent
{
/// The number of no triangle, and the most triangles that a scene can have.
constexpr std::uint32_t noTriangle = 0xFFFFFFFFu;

enum class Shading
{
  Smooth, ///< interpolated point normals; flat where a surface has none
  Flat,   ///< cell normals, the triangle's own where a surface has none
  Unlit   ///< the plain colour
};

/// How a surface reflects light, and which sides of it are drawn.
struct Appearance
{
  double diffuse = 1.0, ambient = 0.0; ///< coefficients
  Vec3 diffuseColor{ 1.0 };            ///< also what an unlit surface shows
  Vec3 ambientColor{ 1.0 };
  Shading shading = Shading::Smooth;
  bool cullFront = false; ///< front faces (counter-clockwise) are not drawn
  bool cullBack = false;  ///< back faces are not drawn

  /// To the bit: 0 is not -0.
  bool isSameAs(const Appearance& other) const
  {
    return std::memcmp(this, &other, 8 * sizeof(double)) == 0 && this->shading == other.shading &&
      this->cullFront == other.cullFront && this->cullBack == other.cullBack;
  }

  /// rho_d and rho_a of the light model.
  Vec3 diffuseReflection() const { return this->diffuseColor * this->diffuse; }
  Vec3 ambientReflection() const { return this->ambientColor * this->ambient; }

  bool isCulling() const { return this->cullFront || this->cullBack; }
  /// Whether a face is not drawn: sum is positive where its front is seen (Hit::sum).
  bool isCulled(double sum) const
  {
    return (this->cullFront && sum > 0.0) || (this->cullBack && sum < 0.0);
  }
};

static_assert(offsetof(Appearance, shading) == 8 * sizeof(double), "isSameAs() compares them");

/// A triangle mesh: triangle t has the corners 3t, 3t+1, 3t+2.
struct Surface
{
  // Geometry.
  TupleSpan points;
  IndexSpan corners;

  // Attributes.
  TupleSpan pointNormals; ///< one a point, or none
  /// Where corners at one point have different normals: which of pointNormals each corner
  /// has. None: that of its point.
  IndexSpan normalNumbers;
  TupleSpan cellNormals; ///< one a cell, or none

  Appearance appearance;

  // Origin.
  /// The cell of each triangle; nullptr: cell = firstCell + triangle.
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
  std::size_t triangleCount() const { return this->corners.size / 3; }
  std::int64_t cellOf(std::size_t triangle) const
  {
    return this->cells ? this->cells[triangle]
                       : this->firstCell + static_cast<std::int64_t>(triangle);
  }
};
}

#endif
