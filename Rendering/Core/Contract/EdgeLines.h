// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the image contract for edges of cells: which samples show a line
 *
 * Edges are not primitives of their own. A sample that sees a cell shows an edge of this cell if it
 * lies, on the image plane, within half a line width of the edge:
 *
 * 1. Project the two ends of the edge: (x / w, y / w). In a perspective view, an edge that reaches
 *    behind the eye is cut first (projectEdge()).
 * 2. Compare the squared distance of the sample to this segment with the square of half the width
 *    (EdgeLine::isAt()). Both are lengths on the image plane.
 *
 * All edges of the cell count, not only those of the triangle that the sample sees, so that lines
 * have no notches where they meet at a corner. There is no depth to compare and no offset, so faces
 * never hide parts of their own edges, whatever the scale of the coordinates. Where two cells meet,
 * each shows half of the line. Where a surface ends, its line has half the width. VTK's OpenGL
 * renderer draws edges by distances on the screen, too, but per triangle and with soft borders.
 *
 * The colour is (1 - e) lit + e edge, with the opacity e of the edges; the colour of the edge is
 * not lit (mixedWithEdge()).
 */
#ifndef lambent_EdgeLines_h
#define lambent_EdgeLines_h

#include "ImageContract.h"

namespace lambent
{
/// An edge of a cell as a segment on the image plane.
struct EdgeLine
{
  double ax, ay, bx, by;

  /// The squared distance of a point to the segment: to a + t (b - a), where t is the projection of
  /// the point on the line, clamped to [0, 1]. A segment without length is the point a.
  double squaredDistance(double x, double y) const
  {
    const double dx = this->bx - this->ax, dy = this->by - this->ay;
    const double px = x - this->ax, py = y - this->ay;
    const double square = dx * dx + dy * dy;
    const double along = px * dx + py * dy;
    const double t = !(along > 0.0 && square > 0.0) ? 0.0 : along < square ? along / square : 1.0;
    const double ex = px - t * dx, ey = py - t * dy;
    return ex * ex + ey * ey;
  }

  /// Whether a sample shows the line. False for NaN.
  bool isAt(double x, double y, double squaredHalfWidth) const
  {
    return this->squaredDistance(x, y) <= squaredHalfWidth;
  }
};

/// In a perspective view, edges end at this fraction of the depth of their farther end. Nearer
/// points would be projected towards infinity.
constexpr double nearestEdgeDepth = 0x1p-20;

/// The point of the edge from `far` to `near` at a depth between theirs.
inline FramePoint cutEdge(const FramePoint& far, const FramePoint& near, double depth)
{
  const double s = (far.z - depth) / (far.z - near.z);
  return { far.x + s * (near.x - far.x), far.y + s * (near.y - far.y), depth, depth };
}

/// Projects an edge. Returns false if no part of it is in front of the eye, and for NaN. In a
/// parallel view nothing is cut.
inline bool projectEdge(FramePoint a, FramePoint b, bool parallel, EdgeLine& line)
{
  if (!parallel)
  {
    const bool isFirstFar = a.z >= b.z;
    const FramePoint& far = isFirstFar ? a : b;
    FramePoint& near = isFirstFar ? b : a;
    if (!(far.z > 0.0))
    {
      return false;
    }
    const double depth = nearestEdgeDepth * far.z;
    if (near.z <= depth)
    {
      near = cutEdge(far, near, depth);
    }
  }
  line = { a.x / a.w, a.y / a.w, b.x / b.w, b.y / b.w };
  return true;
}

/// The colour of a sample that shows an edge.
inline Vec3 mixedWithEdge(const Vec3& lit, const Vec3& edge, double opacity)
{
  return lit * (1.0 - opacity) + edge * opacity;
}
}

#endif
