// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief convert a body to a surface of the core, without VTK
 */
#ifndef BodySurface_h
#define BodySurface_h

#include "Stage.h"

#include "CellLines.h"
#include "CheckedFaces.h"
#include "CornerNormals.h"
#include "DrawnTriangles.h"
#include "Parallel.h"
#include "Triangulation.h"

#include <memory>

/// The surface and the memory that its spans point to.
class BodySurface
{
public:
  BodySurface(const Body& body, const lambent::Parallel& parallel);
  BodySurface(const BodySurface&) = delete;
  void operator=(const BodySurface&) = delete;

  const lambent::Surface& surface() const { return this->Result; }

  /// The normals that vtkLambentNormals computes for the body, one per point.
  std::vector<Vec3> pointNormals(lambent::Weighting how, const lambent::Parallel& parallel) const;

  /// Adds the array of that name, or an empty attribute.
  void addAttribute(const Body& body, const std::string& name, bool isPerCell);

  /// Sets the normals that vtkLambentRayTracer computes for the body, one per corner.
  void computeNormals(const lambent::Parallel& parallel);

  /// The drawn cells of the body, with these normals and a separate point for each corner, and
  /// transformed; strips become triangles. They can then be shuffled. If the transform mirrors, the
  /// faces must be triangles.
  Body withOwnCorners(const Body& body, const lambent::Parallel& parallel) const;

private:
  /// Polygons, and the triangles of strips.
  lambent::CheckedFaces faces(const lambent::Parallel& parallel) const;
  void setPoints(const Body& body, const lambent::Parallel& parallel);
  void setColors(const Body& body);
  void setTexture(const StageTexture& texture);
  void copyCells(const Body& body);
  void setCells(const Body& body, const lambent::Parallel& parallel);
  void findUses(const Body& body, const lambent::Parallel& parallel);
  void setSpheres(const Body& body);
  void setLines(const Body& body, const lambent::Parallel& parallel);
  void chooseTriangles(const Body& body, const lambent::Parallel& parallel);
  lambent::CellSpan polygons() const;
  lambent::CellSpan strips() const;
  lambent::CellSpan cells() const;
  lambent::CornerNormals cornerNormals(
    const lambent::CheckedFaces& faces, const lambent::Parallel& parallel) const;
  lambent::TupleSpan keepNormals(
    const std::vector<Vec3>& normals, std::vector<double>& memory) const;

  const bool HasFloats;
  const bool HasNarrowIds;
  const bool HasStrips;
  const lambent::Transform Placement;
  const lambent::Cofactors PlacementOfNormals;
  std::vector<float> Floats;
  std::vector<double> Doubles, Placed;
  std::vector<float> FloatRadii;
  std::vector<double> DoubleRadii;
  std::vector<std::int32_t> Offsets32, Ids32;
  std::vector<std::int64_t> Offsets64, Ids64;
  std::vector<double> PointNormals, CellNormals;
  lambent::LineList Lines;
  lambent::TriangleList Triangles;
  lambent::UnwrittenVector<unsigned char> CellEdges;
  lambent::IndexSpan AllCorners;
  lambent::UnwrittenVector<lambent::CellUse> Uses;
  lambent::DrawnTriangles Drawn;
  lambent::DrawnTriangles::Indices DrawnCorners, DrawnNumbers;
  lambent::CornerNormals Normals;
  lambent::UnwrittenVector<std::int32_t> NormalNumbers;
  std::vector<std::vector<unsigned char>> Attributes;
  StageColors ColorSettings;
  std::vector<unsigned char> ColorValues;
  std::unique_ptr<lambent::ColorTable> Table;
  lambent::ColorArray Colors;
  std::vector<unsigned char> Pixels, Places;
  lambent::TextureMap Map;
  lambent::Surface Result;
};

#endif
