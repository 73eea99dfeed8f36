// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief polydata as a surface of the core's scene
 *
 * Float and double points, normals and triangles are used where they are. Other
 * number types and memory layouts are converted, and polygons and strips cut into
 * triangles, into memory that the SurfaceFromVTK owns. Computed normals come from the same
 * spans: nothing is converted or merged twice.
 */
#ifndef SurfaceFromVTK_h
#define SurfaceFromVTK_h

#include "CornerNormals.h"
#include "MergedFaces.h"
#include "Parallel.h"
#include "Scene.h"
#include "SceneSettings.h"
#include "SpansFromVTK.h"
#include "Triangulation.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace lambent::adapters
{
class SurfaceFromVTK
{
public:
  /// The polydata must outlive this object. Throws std::runtime_error, as do the
  /// others, with a message for the user.
  SurfaceFromVTK(vtkPolyData* polyData, const Appearance& appearance, const Parallel& parallel);

  const Surface& surface() const { return this->Result; }

  /// Normals for smooth shading, one for each point; they must outlive this object.
  void setPointNormals(vtkDataArray* normals);
  /// Computes them, one for each corner (CornerNormals.h).
  void computeNormals(double featureAngle, const Parallel& parallel);

  /// Adds the array of that name, or, if the polydata has none, an empty attribute.
  void addAttribute(const SceneSettings::PassArray& array);

  /// What is wrong with a cell that names a point that does not exist.
  std::string describeWrongCell(std::int64_t cell) const;

private:
  void setPoints();
  void setCells(const Parallel& parallel);
  std::int64_t firstPolygon() const;
  TupleSpan normals(vtkDataArray* normals, vtkIdType expected, const char* kind);

  vtkPolyData* Input;
  CellSpan Polygons, Strips;
  MergedFaces Merged; ///< of both, until normals are computed; empty where there are no strips
  Surface Result;
  TriangleList Triangles;
  CornerNormals Normals;                       ///< where they are computed
  UnwrittenVector<std::int32_t> NormalNumbers; ///< of the corners of Triangles
  SpansFromVTK Spans;
};
}

#endif
