// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the image contract for lines and points that have a width in pixels
 *
 * A line has two ends. A point is a line whose ends are the same. Part of ImageContract.h.
 *
 * 1. If one end is not in front of the eye, the line is cut in front of the eye.
 * 2. The ends are projected onto the image plane.
 * 3. A ray hits if it crosses the image plane within half the width of the projected line, ends
 *    included. So lines have round caps, the joints of polylines have no gaps, and points are
 *    discs.
 * 4. The line bulges towards the eye like a tube of its width.
 *
 * By the bulge a line that lies on a surface is visible: the surface hides at most the half of the
 * tube that is inside of it. This holds at every scale of coordinates and for every slope of the
 * surface, since the bulge has the size of the line in the picture. It needs no offset that depends
 * on the scene or on the precision of a depth buffer.
 */
#ifndef lambent_LineContract_h
#define lambent_LineContract_h

#include "ImageContract.h"

#include <utility>

namespace lambent
{
/// A line as it is drawn: projected, in units of half its width. The first end is the one that
/// comes first in the frame (comesBefore()), so that a line and the same line turned are equal to
/// the bit.
struct Line
{
  double x, y;      ///< the first end on the image plane
  double dx, dy;    ///< from the first end to the second, in half widths
  double perSquare; ///< 1 / (dx^2 + dy^2), or 0 for a point
  double half;      ///< half the width, on the image plane
  double perHalf;   ///< 1 / half
  double az, bz;    ///< depths of the ends
  double aShare;    ///< what the second end contributes to data at the first; 0 unless it is cut
  double bulge;     ///< towards the eye at the centre line; per depth in a perspective view
  bool parallel;
  bool isTurned; ///< the first end is the second one of the surface's line
};

/// The hit of a ray on a line.
struct LineHit
{
  double depth; ///< along the viewing direction, on the bulge
  double a, b;  ///< what the ends of the surface's line contribute to data at the hit
  double u, v;  ///< from the nearest point of the projected line to the ray, in half widths
  double rise;  ///< sqrt(1 - u^2 - v^2): the height of the bulge, in half widths
  double t;     ///< the place of that point, from 0 at the first end to 1 at the second
};

/// An order of points in the frame: by depth, then from the left, then from the bottom.
inline bool comesBefore(const FramePoint& p, const FramePoint& q)
{
  return p.z != q.z ? p.z < q.z : p.x != q.x ? p.x < q.x : p.y < q.y;
}

/**
 * Projects the line from a to b, which has half the width `half` on the image plane. Returns false
 * if it is not drawn: in a perspective view, if both ends are at or behind the eye.
 *
 * A perspective view cuts a line that begins or ends at a depth below s = 2^-20 times the depth of
 * its farther end, where its depth is s. What is cut off would be seen at an angle to the viewing
 * direction whose tangent is about a million times that of the farther end, unless it points at the
 * eye. A parallel view cuts nothing: the hit must have a depth above 0.
 *
 * Lengths on the image plane are divided by half the width. So no square of a small or of a large
 * picture underflows or overflows. A line of less than 1e-150 half widths counts as a point.
 *
 * In a perspective view the bulge at depth z is half z, half the width of the line in space, but
 * not more than z / 2.
 */
inline bool projectLine(FramePoint a, FramePoint b, double half, bool parallel, Line& line)
{
  constexpr double nearest = 1.0 / (1 << 20), shortest = 1e-300;
  line.isTurned = comesBefore(b, a);
  if (line.isTurned)
  {
    std::swap(a, b);
  }
  line.aShare = 0.0;
  if (!parallel)
  {
    const double s = b.z * nearest;
    if (!(s > 0.0))
    {
      return false;
    }
    if (a.z < s)
    {
      line.aShare = (s - a.z) / (b.z - a.z);
      a = { a.x + line.aShare * (b.x - a.x), a.y + line.aShare * (b.y - a.y), s, s };
    }
  }
  line.half = half;
  line.perHalf = 1.0 / half;
  line.x = a.x / a.w;
  line.y = a.y / a.w;
  line.dx = (b.x / b.w - line.x) * line.perHalf;
  line.dy = (b.y / b.w - line.y) * line.perHalf;
  const double square = line.dx * line.dx + line.dy * line.dy;
  line.perSquare = square > shortest ? 1.0 / square : 0.0;
  line.az = a.z;
  line.bz = b.z;
  line.bulge = parallel ? half : std::min(half, 0.5);
  line.parallel = parallel;
  return true;
}

/**
 * Tests the ray through (x, y) of the image plane against a line.
 *
 *     e = ((x, y) - p) / half                from the first end p
 *     t = clamp(e.d / d.d, 0, 1)             the nearest point of the line; 0 for a point
 *     (u, v) = e - t d                       must not be longer than 1
 *     s = t az / (t az + (1 - t) bz)         the share of the second end; t in a parallel view
 *     z = (1 - s) az + s bz                  the depth on the centre line
 *     depth = z - sqrt(1 - u^2 - v^2) bulge  times z in a perspective view
 *
 * Whatever t comes out as, it is the place of a point of the line. So rounding of t cannot make a
 * line wider.
 *
 * Returns false if the hit is at or behind the eye, and for NaN.
 */
inline bool intersectLine(const Line& line, double x, double y, LineHit& hit)
{
  const double ex = (x - line.x) * line.perHalf, ey = (y - line.y) * line.perHalf;
  const double along = (ex * line.dx + ey * line.dy) * line.perSquare;
  const double t = along > 0.0 ? (along < 1.0 ? along : 1.0) : 0.0;
  hit.t = t;
  hit.u = ex - t * line.dx;
  hit.v = ey - t * line.dy;
  const double square = hit.u * hit.u + hit.v * hit.v;
  if (!(square <= 1.0))
  {
    return false;
  }
  const double s = line.parallel ? t : t * line.az / (t * line.az + (1.0 - t) * line.bz);
  const double z = (1.0 - s) * line.az + s * line.bz;
  const double share = line.aShare + s * (1.0 - line.aShare);
  hit.a = line.isTurned ? share : 1.0 - share;
  hit.b = line.isTurned ? 1.0 - share : share;
  hit.rise = std::sqrt(1.0 - square);
  hit.depth = z - hit.rise * (line.parallel ? line.bulge : line.bulge * z);
  return hit.depth > 0.0 && hit.depth < std::numeric_limits<double>::infinity();
}
}

#endif
