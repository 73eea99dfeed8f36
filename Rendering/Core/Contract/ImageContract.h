// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the image contract: everything that decides the bits of a pixel
 *
 * A picture is a pure function of its scene. Whatever produces a pixel, in
 * whatever order and on however many threads, computes it with the functions of
 * this file, of Arithmetic.h and of Elementary.h, in the order written there:
 *
 * - IEEE binary64, + - * / sqrt, rounded to nearest. The module is compiled
 *   without contraction (-ffp-contract=off) and without -ffast-math.
 * - GLM gives the types only. Its dot() and normalize() may sum in another order
 *   in another release; ours may not.
 * - Float, and whatever else is fast, may decide what is proven to come out the same
 *   here, and nothing else: which triangles a ray cannot meet, and which hits are
 *   certain (PointLattice.h, Coverage.h).
 * - Normals of smooth surfaces that bring none are those of CornerNormals.h, rounded to float.
 * - The ray-triangle test is that of Woop, Benthin and Wald, "Watertight
 *   Ray/Triangle Intersection", JCGT 2(1), 2013, with one more condition, see
 *   intersect().
 *
 * A change that can alter a single bit of a picture changes users' baselines: it
 * needs a new ImageContractVersion and a line in the change list.
 *
 * Version 2: computed normals leave edges sharp that are sharper than the feature angle, and
 * a triangle's normals say which of its sides is the front (Shader::isReversed()). Before,
 * corners of boxes were shaded like cushions, sheets whose faces are there twice were speckled,
 * since normals cancelled to rounding noise, and mirrored meshes were dark outside. Polygons
 * that touch themselves are filled exactly (TouchingPolygon.h), not across their notches.
 */
#ifndef lambent_ImageContract_h
#define lambent_ImageContract_h

#include "Arithmetic.h"

#include <algorithm>
#include <limits>

namespace lambent
{
constexpr int ImageContractVersion = 2;

/// A point in the camera's frame: right, up, forward, and the weight w that the
/// position on the image plane is divided by (forward in a perspective view, 1
/// in a parallel one). The image plane lies at distance 1.
struct FramePoint
{
  double x, y, z, w;
};

/// Where a ray meets a triangle: the three edge functions, their sum, and the
/// depth along the viewing direction. e / sum are the barycentric coordinates;
/// the sum is positive where the front (counter-clockwise) side is seen.
struct Hit
{
  double e0, e1, e2, sum, depth;
};

/// True where zero lies within the range of the three values.
inline bool spansZero(double a, double b, double c)
{
  return std::min(a, std::min(b, c)) <= 0.0 && std::max(a, std::max(b, c)) >= 0.0;
}

/**
 * The ray through (x, y) of the image plane against the triangle a b c.
 *
 * Each vertex is sheared so that the ray becomes the third axis. The sheared
 * vertex depends on the vertex and the ray alone, and since rounding is
 * monotonic each edge function has the right sign or is zero: no ray passes
 * between two triangles that share an edge or a vertex.
 *
 * A hit must also lie in the bounding box of the sheared triangle. Wherever the
 * test is exact that says nothing new. It matters for a triangle so thin that
 * its edge functions round to zero: without it such a triangle is also hit where
 * its long edges would go on beyond its ends, so that no projected bounds could
 * ever be conservative.
 *
 * Not hit: a triangle whose edge functions sum to zero, one at or behind the
 * eye, and anything that is not a number.
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

/// The byte of a colour channel: floor(255 clamp(value, 0, 1) + 1/2), no gamma;
/// what is not a number gives 0.
inline unsigned char toByte(double value)
{
  const double clamped = value > 0.0 ? (value < 1.0 ? value : 1.0) : 0.0;
  return static_cast<unsigned char>(255.0 * clamped + 0.5);
}

/// A channel as the float of an image. What is not a number always becomes the same
/// one: of the many that there are, processors choose different ones.
inline float toFloat(double value)
{
  return std::isnan(value) ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(value);
}
}

#endif
