// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the surfaces of a scene, with primitives and points numbered consecutively
 *
 * A primitive is what a ray hits as a whole: a triangle, a sphere or a line. Primitives and points
 * are counted over all surfaces in order. So (input, cell, primitive within the cell) becomes one
 * number. Of two hits at the same depth, the one with the smaller number is kept.
 */
#ifndef lambent_SceneMesh_h
#define lambent_SceneMesh_h

#include "Parallel.h"
#include "Scene.h"
#include "UnwrittenVector.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace lambent
{
/// Where the colour of a hit comes from.
enum class ColorSource : unsigned char
{
  Primitive,    ///< the appearance, or the colour of the cell
  Interpolated, ///< the colours of the points
  MappedLast    ///< a table, and the interpolated numbers of the points
};

class SceneMesh
{
public:
  /// A surface. All data needed to look up single primitives is in one cache line, since there may
  /// be as many surfaces as primitives.
  struct alignas(64) Part
  {
    const Surface* surface;
    /// The appearance of the previous part, if the two are equal. So comparing addresses is usually
    /// enough.
    const Appearance* appearance;
    std::size_t firstPoint;
    std::uint32_t firstPrimitive, primitiveCount;

    Part() = default;
    Part(const Surface& s, const Appearance& a, std::size_t primitive, std::size_t point)
      : surface(&s)
      , appearance(&a)
      , firstPoint(point)
      , firstPrimitive(static_cast<std::uint32_t>(primitive))
      , primitiveCount(static_cast<std::uint32_t>(s.primitiveCount()))
      , Points(s.points.data)
      , Corners(s.corners.data)
      , Normals(s.pointNormals.data)
      , HasDoublePoints(s.points.isDouble)
      , HasWideCorners(s.corners.is64Bit)
      , HasDoubleNormals(s.pointNormals.isDouble)
      , Flags(static_cast<unsigned char>((s.isSmooth() ? Smooth : 0) |
          (s.normalNumbers.data ? NormalNumbers : 0) | (s.cellNormals ? CellNormals : 0) |
          (a.isCulling() ? Culling : 0) | (s.colors ? Colored : 0) |
          (s.isTransparent() ? Transparent : 0) | (s.hasTexture() ? Textured : 0) |
          (a.edges.areVisible && s.kind() == PrimitiveKind::Triangle ? Edges : 0)))
      , Source(sourceOf(s))
      , IsShiny(a.isShiny())
      , Kind(s.kind())
    {
    }

    // The surface's arrays, without their sizes.
    TupleSpan points() const { return { this->Points, this->HasDoublePoints, 0 }; }
    IndexSpan corners() const { return { this->Corners, this->HasWideCorners, 0 }; }
    TupleSpan pointNormals() const { return { this->Normals, this->HasDoubleNormals, 0 }; }
    bool isSmooth() const { return (this->Flags & Smooth) != 0; }
    bool hasNormalNumbers() const { return (this->Flags & NormalNumbers) != 0; }
    bool hasCellNormals() const { return (this->Flags & CellNormals) != 0; }
    bool isCulling() const { return (this->Flags & Culling) != 0; }
    ColorSource colorSource() const { return this->Source; }
    /// Whether all hits have the same colour, before they are lit.
    bool hasOneColor() const { return (this->Flags & Colored) == 0; }
    PrimitiveKind kind() const { return this->Kind; }
    bool hasTexture() const { return (this->Flags & Textured) != 0; }
    bool isTransparent() const { return (this->Flags & Transparent) != 0; }

    /// The sphere that a primitive, counted over all surfaces, belongs to, and which of its sides
    /// are drawn (Surface::primitivesPerSphere()).
    std::size_t sphereOf(std::uint32_t primitive) const
    {
      return (primitive - this->firstPrimitive) >> (this->isTransparent() ? 1 : 0);
    }
    bool hasOutside(std::uint32_t primitive) const
    {
      return !this->appearance->cullFront &&
        !(this->isTransparent() && ((primitive - this->firstPrimitive) & 1) != 0);
    }
    bool hasInside(std::uint32_t primitive) const
    {
      return !this->appearance->cullBack &&
        !(this->isTransparent() && ((primitive - this->firstPrimitive) & 1) == 0);
    }

    /// Whether lines are drawn along the edges of its cells.
    bool hasEdges() const { return (this->Flags & Edges) != 0; }
    bool isShiny() const { return this->IsShiny; }

    /// Reads the next part.
    std::size_t pointCount() const { return (this + 1)->firstPoint - this->firstPoint; }

    /// Whether a primitive, counted over all surfaces, belongs to this part.
    bool holds(std::size_t primitive) const
    {
      return primitive - this->firstPrimitive < this->primitiveCount;
    }

  private:
    static ColorSource sourceOf(const Surface& s)
    {
      return !s.colors || s.colors->values.isPerCell || s.kind() == PrimitiveKind::Sphere
        ? ColorSource::Primitive
        : s.colors->isMappedLast ? ColorSource::MappedLast
                                 : ColorSource::Interpolated;
    }

    enum : unsigned char
    {
      Smooth = 1,
      NormalNumbers = 2,
      CellNormals = 4,
      Culling = 8,
      Colored = 16,
      Transparent = 32,
      Textured = 64,
      Edges = 128
    };
    const void* Points;
    const void* Corners;
    const void* Normals;
    bool HasDoublePoints, HasWideCorners, HasDoubleNormals;
    unsigned char Flags;
    ColorSource Source;
    bool IsShiny;
    PrimitiveKind Kind;
  };
  static_assert(sizeof(Part) == 64);

  explicit SceneMesh(const std::vector<Surface>& surfaces, const Parallel& parallel = Parallel());

  std::size_t primitiveCount() const { return this->Primitives; }
  std::size_t pointCount() const { return this->Points; }
  /// Whether all primitives are triangles.
  bool hasOnlyTriangles() const { return this->HasOnlyTriangles; }
  /// Whether some surfaces are transparent.
  bool hasTransparency() const { return this->HasTransparency; }
  /// Whether the opacity of some surfaces varies over them.
  bool hasVaryingOpacity() const { return this->HasVaryingOpacity; }

  /// The part that holds a primitive.
  const Part& partOf(std::size_t primitive) const
  {
    const Part* part = &this->Parts[this->FirstParts[primitive >> this->Shift]];
    while (!part->holds(primitive))
    {
      ++part;
    }
    return *part;
  }

  /// Prefetches what partOf() reads, for several primitives or noPrimitive.
  void prefetchPartsOf(const std::uint32_t* primitives, int count) const
  {
    if (this->Parts.size() <= 2)
    {
      return; // there is one surface
    }
    for (int k = 0; k < count; ++k)
    {
      if (primitives[k] != noPrimitive)
      {
        hwy::Prefetch(&this->Parts[this->FirstParts[primitives[k] >> this->Shift]]);
      }
    }
  }

  /// Splits [begin, end), counted over all surfaces, where one surface ends and the next begins,
  /// and calls body(part, begin, end) for each piece. There, begin and end count within the
  /// surface.
  template <typename Body>
  void forPrimitives(std::size_t begin, std::size_t end, Body&& body) const
  {
    this->forPieces(begin, end, &Part::firstPrimitive, body);
  }
  template <typename Body>
  void forPoints(std::size_t begin, std::size_t end, Body&& body) const
  {
    this->forPieces(begin, end, &Part::firstPoint, body);
  }

private:
  /// Surfaces that one worker reads.
  struct Block
  {
    std::size_t begin, end;
    std::size_t primitives = 0, points = 0; ///< their number; after join(), of those before it
    bool hasOnlyTriangles = true, hasTransparency = false, hasVaryingOpacity = false;
    const Appearance* first = nullptr; ///< of the first surface, and those equal to it
    const Appearance* last = nullptr;
    const Appearance* replacement = nullptr; ///< of first, in the whole scene
  };
  void read(const std::vector<Surface>& surfaces, Block& block);
  void join(std::vector<Block>& blocks);
  void number(const Block& block);

  template <typename Number, typename Body>
  void forPieces(std::size_t begin, std::size_t end, Number Part::*first, Body&& body) const
  {
    auto part = std::upper_bound(this->Parts.begin(), this->Parts.end() - 1, begin,
                  [first](std::size_t t, const Part& p) { return t < p.*first; }) -
      1;
    for (; begin < end; ++part)
    {
      const std::size_t pieceEnd = std::min<std::size_t>(end, (*(part + 1)).*first);
      if (begin < pieceEnd)
      {
        body(*part, begin - (*part).*first, pieceEnd - (*part).*first);
      }
      begin = pieceEnd;
    }
  }

  UnwrittenVector<Part> Parts; ///< the last one marks the end
  /// The part of every 2^Shift-th primitive. There are about as many entries as parts, so finding a
  /// part takes a few steps on average.
  UnwrittenVector<std::uint32_t> FirstParts;
  int Shift = 0;
  std::size_t Primitives = 0;
  std::size_t Points = 0;
  bool HasOnlyTriangles = true;
  bool HasTransparency = false, HasVaryingOpacity = false;
};
}

#endif
