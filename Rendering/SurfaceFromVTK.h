// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief polydata as surfaces of the core's scene
 *
 * Points and normals of float or double, and triangles, are used in place. Other number types and
 * memory layouts are converted, points and normals transformed, polygons and strips divided into
 * triangles, and triangles of ghost cells left out, in memory that the SurfaceFromVTK owns.
 * Computed normals use the same spans, so nothing is converted or merged twice. Lines and points
 * come before the faces (LinesFromVTK.h).
 */
#ifndef SurfaceFromVTK_h
#define SurfaceFromVTK_h

#include "ColorsFromVTK.h"
#include "CornerNormals.h"
#include "DrawnTriangles.h"
#include "LinesFromVTK.h"
#include "MergedFaces.h"
#include "Parallel.h"
#include "Scene.h"
#include "SceneSettings.h"
#include "SpansFromVTK.h"
#include "Transform.h"
#include "Triangulation.h"

#include <memory>
#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace lambent::adapters
{
class SurfaceFromVTK
{
public:
  /// The polydata must outlive this object. This and the other functions throw std::runtime_error
  /// with a message for the user.
  SurfaceFromVTK(const SceneSettings::Input& input, const Appearance& appearance,
    const LineStyle& lineStyle, const Parallel& parallel);

  /// The faces or spheres.
  const Surface& surface() const { return this->Result; }
  /// Calls body(surface) for the surfaces of lines and points and that of the faces, in order.
  /// Their addresses stay; lines and points have no attributes, normals and colours here.
  template <typename Body>
  void forSurfaces(const Body& body) const
  {
    for (const auto& lines : this->lines())
    {
      body(*lines);
    }
    body(this->Result);
  }
  /// Appends all surfaces.
  void append(std::vector<Surface>& to) const;
  bool hasLines() const { return this->Lines && !this->Lines->isEmpty(); }

  /// Sets the normals for smooth shading, one for each point. They must outlive this object.
  void setPointNormals(vtkDataArray* normals, const Parallel& parallel);
  /// Computes normals, one for each corner (CornerNormals.h).
  void computeNormals(double featureAngle, const Parallel& parallel);

  /// Sets the colours of points or cells. The settings must outlive this object.
  void addColors(const InputColors& settings);

  /// Sets a texture and the texture coordinates of the polydata, which must have some.
  void addTexture(const Texture& texture);

  /// Adds the array of that name, or, if the polydata has none, an empty attribute.
  void addAttribute(const SceneSettings::PassArray& array);

  /// What is wrong with a cell that names a missing point, and the remedy.
  std::string describeWrongCell(std::int64_t cell) const;

private:
  const std::vector<std::unique_ptr<Surface>>& lines() const;
  void setPoints(const Parallel& parallel);
  void setCells(const Parallel& parallel);
  void chooseTriangles(const Parallel& parallel);
  void setNormalNumbers(const CellSpan& faces, const Parallel& parallel);
  std::int64_t firstPolygon() const;
  /// Normals of "point" or "cell" kind, transformed.
  TupleSpan normals(
    vtkDataArray* normals, vtkIdType expected, const char* kind, const Parallel& parallel);

  vtkPolyData* Input;
  const Transform Placement;
  const Cofactors PlacementOfNormals;
  UnwrittenVector<double> Points, GivenNormals; ///< transformed
  TupleSpan PointNormals;                       ///< the input's, if they are used
  CellSpan Polygons, Strips;
  MergedFaces Merged; ///< polygons and strips, until normals are computed; empty without strips
  Surface Result;
  TriangleList Triangles;
  UnwrittenVector<unsigned char> CellEdges; ///< of triangles of polygons, if edges are visible
  IndexSpan AllCorners; ///< of all triangles, with the winding that they have in the input
  UnwrittenVector<CellUse> Uses;
  DrawnTriangles Drawn;
  DrawnTriangles::Indices DrawnCorners, DrawnNumbers;
  CornerNormals Normals;                       ///< if they are computed
  UnwrittenVector<std::int32_t> NormalNumbers; ///< of the corners of Triangles
  SpansFromVTK Spans;
  std::unique_ptr<LinesFromVTK> Lines;        ///< unless there are spheres
  std::unique_ptr<ColorsFromVTK> Colors;      ///< if the scalars are visible
  std::unique_ptr<const TextureMap> Textured; ///< if it has a texture
};
}

#endif
