// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the image contract: every rule that decides the bits of a pixel
 *
 * An image is a pure function of its scene. All rendering code, in any order and on any number of
 * threads, must compute pixels with the functions of this file, Arithmetic.h and Elementary.h, in
 * the order written there, and with the definitions built on them: lines in LineContract.h, edges
 * of cells in EdgeLines.h, surface points and attributes in TrianglePoints.h, SpherePoints.h and
 * LinePoints.h, colours in SurfaceColor.h, LightModel.h and SampleShading.h, averages and alpha in
 * Film.h, the background in Background.h, and passes in PassTable.h and PassStore.h.
 *
 * - Arithmetic is IEEE binary64 with + - * / sqrt, rounded to nearest. The module is compiled
 *   without contraction (-ffp-contract=off) and without -ffast-math.
 * - GLM provides the types only. Its dot() and normalize() may sum in another order in another
 *   release; ours may not.
 * - Float and other fast arithmetic may decide only what is proven to come out the same here: which
 *   triangles a ray cannot hit, and which hits are certain (PointLattice.h, Coverage.h,
 *   CastingKernel.h).
 * - Smooth surfaces without normals get those of CornerNormals.h, rounded to float. The points and
 *   normals of transformed surfaces are those of Transform.h.
 * - The colours of textures are those of Texture.h. They multiply what the light model gives.
 * - The ray-triangle test is that of Woop, Benthin and Wald, "Watertight Ray/Triangle
 *   Intersection", JCGT 2(1), 2013, with one more condition; see intersect().
 * - The ray-sphere test is that of Hearn and Baker, as Haines et al. give it; see
 *   intersectSphere().
 * - Hits on transparent surfaces are sorted, and those on shared edges counted once, as
 *   SortedLayers.h has it; LayerPainting.h composites them.
 *
 * A change that can alter a single bit of an image changes users' baselines. It needs a new
 * ImageContractVersion and an entry in the change log.
 *
 * Version 2: computed normals leave edges sharp that are sharper than the feature angle, and a
 * triangle's normals determine its front (TrianglePoints::isReversed()). In version 1, corners of
 * boxes were shaded like cushions; sheets with duplicate faces were speckled, since their normals
 * cancelled to rounding noise; and mirrored meshes were dark outside. Polygons that touch
 * themselves are now filled exactly (TouchingPolygon.h), not across their notches.
 */
#ifndef lambent_ImageContract_h
#define lambent_ImageContract_h

#include "Arithmetic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambent
{
constexpr int ImageContractVersion = 2;

/// A point in the camera's frame: right, up, forward, and the weight w that divides its position on
/// the image plane (forward in a perspective view, 1 in a parallel one). The image plane lies at
/// distance 1.
struct FramePoint
{
  double x, y, z, w;
};

/// The hit of a ray on a triangle: the three edge functions, their sum, and the depth along the
/// viewing direction. e / sum are the barycentric coordinates. The sum is positive where the front
/// (counter-clockwise) side is seen.
struct Hit
{
  double e0, e1, e2, sum, depth;
};

/// True if zero lies within the range of the three values.
inline bool spansZero(double a, double b, double c)
{
  return std::min(a, std::min(b, c)) <= 0.0 && std::max(a, std::max(b, c)) >= 0.0;
}

/**
 * Tests the ray through (x, y) of the image plane against the triangle a b c.
 *
 * Each vertex is sheared so that the ray becomes the third axis. A sheared vertex depends only on
 * the vertex and the ray, and rounding is monotonic. So each edge function has the right sign or
 * is zero, and no ray passes between two triangles that share an edge or a vertex.
 *
 * A hit must also lie in the bounding box of the sheared triangle. Where the test is exact, this
 * condition is redundant. It matters for triangles so thin that their edge functions round to
 * zero. Without it, such a triangle would also be hit where its long edges extend beyond its ends,
 * and no projected bounds could be conservative.
 *
 * Returns false if the edge functions sum to zero, if the hit is at or behind the eye, and for
 * NaN.
 */
inline bool intersect(
  const FramePoint& a, const FramePoint& b, const FramePoint& c, double x, double y, Hit& hit)
{
  const double ax = a.x - x * a.w, ay = a.y - y * a.w;
  const double bx = b.x - x * b.w, by = b.y - y * b.w;
  const double cx = c.x - x * c.w, cy = c.y - y * c.w;
  if (!spansZero(ax, bx, cx) || !spansZero(ay, by, cy))
  {
    return false;
  }
  hit.e0 = bx * cy - by * cx;
  hit.e1 = cx * ay - cy * ax;
  hit.e2 = ax * by - ay * bx;
  const bool front = hit.e0 >= 0.0 && hit.e1 >= 0.0 && hit.e2 >= 0.0;
  const bool back = hit.e0 <= 0.0 && hit.e1 <= 0.0 && hit.e2 <= 0.0;
  if (!front && !back)
  {
    return false;
  }
  hit.sum = (hit.e0 + hit.e1) + hit.e2;
  hit.depth = ((hit.e0 * a.z + hit.e1 * b.z) + hit.e2 * c.z) / hit.sum;
  return hit.sum != 0.0 && hit.depth > 0.0 && hit.depth < std::numeric_limits<double>::infinity();
}

/// A sphere in the camera's frame, and which of its sides are drawn: the outside is its front.
struct Sphere
{
  double x, y, z; ///< the centre
  double radius;
  bool hasOutside, hasInside;
};

/// The hit of a ray on a sphere: the depth along the viewing direction, and the side that is seen.
struct SphereHit
{
  double depth;
  bool isInside;
};

/**
 * Tests the ray o + t d through (x, y) of the image plane against a sphere with centre c and radius
 * r. In a perspective view o = 0 and d = (x, y, 1), in a parallel view o = (x, y, 0) and
 * d = (0, 0, 1); in both, t is the depth.
 *
 * The discriminant is that of D. Hearn and M. P. Baker, "Computer Graphics with OpenGL", as E.
 * Haines et al. give it in "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems,
 * ch. 7, 2019. With f = o - c, a = d.d and b = -f.d,
 *
 *     l = f + (b / a) d          from the centre to the point of the ray nearest to it
 *     disc = r^2 - l.l
 *
 * The classroom form b^2 - a (f.f - r^2) subtracts two large numbers if a sphere is small or far
 * away; r^2 - l.l compares lengths of the sphere's own size. The roots are c / q and q / a, with
 * c = f.f - r^2 and q = b + sqrt(a disc), or b - sqrt(a disc) if b is not positive, so that q is no
 * difference either.
 *
 * The nearer root is on the outside of the sphere and the farther one on its inside. Their order
 * follows from the sign of b, so that rounding cannot exchange them. The hit is the first of the
 * two that has a depth above 0 and is on a side that is drawn.
 *
 * In a parallel view d has two zeros and a is 1; multiplications by them are left out, since they
 * change no bit of a finite number.
 *
 * disc must be above 0. So a ray that only touches a sphere misses it, a sphere of radius 0 is not
 * hit, and q is not 0. Returns false for NaN, and for a radius that is not positive.
 */
inline bool intersectSphere(const Sphere& s, double x, double y, bool parallel, SphereHit& hit)
{
  double a = 1.0, b = s.z, lx = x - s.x, ly = y - s.y, lz = 0.0;
  double fx = lx, fy = ly;
  if (!parallel)
  {
    a = (x * x + y * y) + 1.0;
    b = (s.x * x + s.y * y) + s.z;
    const double nearest = b / a;
    lx = nearest * x - s.x;
    ly = nearest * y - s.y;
    lz = nearest - s.z;
    fx = s.x;
    fy = s.y;
  }
  const double square = s.radius * s.radius;
  const double disc = square - ((lx * lx + ly * ly) + lz * lz);
  if (!(disc > 0.0 && s.radius > 0.0))
  {
    return false;
  }
  const double c = ((fx * fx + fy * fy) + s.z * s.z) - square;
  const double root = std::sqrt(a * disc);
  const double q = b > 0.0 ? b + root : b - root;
  const double outside = b > 0.0 ? c / q : q / a;
  const double inside = b > 0.0 ? q / a : c / q;
  hit.isInside = !(s.hasOutside && outside > 0.0);
  hit.depth = hit.isInside ? inside : outside;
  return hit.depth > 0.0 && hit.depth < std::numeric_limits<double>::infinity() &&
    !(hit.isInside && !s.hasInside);
}

/// The byte of a colour channel: floor(255 clamp(value, 0, 1) + 1/2). There is no gamma. NaN gives
/// 0.
inline unsigned char toByte(double value)
{
  const double clamped = value > 0.0 ? (value < 1.0 ? value : 1.0) : 0.0;
  return static_cast<unsigned char>(255.0 * clamped + 0.5);
}

/// A colour channel as a float. Every NaN becomes the same one, since processors produce different
/// ones.
inline float toFloat(double value)
{
  return std::isnan(value) ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(value);
}
}

#endif
