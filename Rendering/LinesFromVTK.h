// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief what a polydata shows as lines and points: lines, vertices, edges, corners
 *
 * As surfaces of the core that come before that of the faces, in VTK's order of cells:
 *
 * - With vtkProperty::VertexVisibility, the points that cells use, in the colour of vertices.
 * - Representation "surface": the vertices as points, then the lines.
 * - "wireframe": the vertices, then the lines and the edges of polygons and strips. An edge that
 *   cells share is drawn once.
 * - "points": the points that cells use.
 *
 * Faces are drawn in the first case only. Each line and point belongs to the first cell that has
 * it. Ghosts are left out as faces are.
 */
#ifndef LinesFromVTK_h
#define LinesFromVTK_h

#include "CellLines.h"
#include "GhostsFromVTK.h"
#include "SpansFromVTK.h"
#include "Surface.h"

#include <memory>
#include <string>
#include <vector>

class vtkPolyData;
class vtkProperty;

namespace lambent::adapters
{
/// The settings of a vtkProperty; these are its defaults.
struct LineStyle
{
  enum Representation
  {
    Surface,
    Wireframe,
    Points
  };

  Representation representation = Surface;
  double lineWidth = 1.0, pointSize = 1.0; ///< in pixels
  bool linesAreTubes = false, pointsAreSpheres = false;
  bool hasVertices = false;
  Vec3 vertexColor{ 0.5, 1.0, 0.5 };
};

/// nullptr gives the default style.
LineStyle lineStyleFromVTK(vtkProperty* property);

class LinesFromVTK
{
public:
  /// `points` are those of the polydata, perhaps transformed. The polydata and the spans must
  /// outlive this object. Throws std::runtime_error with a message for the user if a cell uses a
  /// point that does not exist, or if a width that is needed is not a positive finite number.
  LinesFromVTK(vtkPolyData* input, const TupleSpan& points, const Appearance& appearance,
    const LineStyle& style, SpansFromVTK& spans, const Parallel& parallel);

  bool isEmpty() const { return this->Surfaces.empty(); }

  /// The surfaces, without attributes. Their addresses stay.
  const std::vector<std::unique_ptr<Surface>>& surfaces() const { return this->Surfaces; }

  /// Appends the surfaces, with the attributes and colours of that of the faces, and the normals of
  /// the points.
  void append(const Surface& faces, const TupleSpan& normals, std::vector<Surface>& to) const;

private:
  void setGroups(vtkPolyData* input, SpansFromVTK& spans);
  void check(const CellGroup& group, const char* kind, const Parallel& parallel) const;
  void setUses(vtkPolyData* input, const Parallel& parallel);
  void addSurfaces(const LineStyle& style);
  void addMarks(const LineStyle& style);
  LineList usedPoints() const;
  Surface* addPoints(LineList&& list, const LineStyle& style);
  Surface* addLines(LineList&& list, const LineStyle& style);
  Surface* add(LineList&& list, double width, bool isRounded);

  const TupleSpan AllPoints;
  Appearance Look;
  const bool UsesFaces; ///< for edges or points
  CellGroup Vertices, Lines, Polygons, Strips;
  UnwrittenVector<CellUse> Uses[2];             ///< of vertices and lines, of polygons and strips
  std::vector<std::unique_ptr<LineList>> Lists; ///< of the surfaces
  std::vector<std::unique_ptr<Surface>> Surfaces;
  const Surface* Marks = nullptr; ///< the surface in the colour of vertices, if there is one
};
}

#endif
