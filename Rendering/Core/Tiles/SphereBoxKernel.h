// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the samples whose rays may hit spheres
 *
 * A ray that intersectSphere() takes for a hit passes its centre at a distance below the radius r,
 * except for rounding: with u = 2^-53 and a centre at distance m from the eye, b errs by at most
 * 3 u m |d| and b / a by 7 u m / |d|, so that l errs by less than 16 u m. So the ray crosses the
 * sphere of radius
 *
 *     R = r + 128 u (m + r)
 *
 * around the same centre, and its hit is not nearer than that sphere: l.l + disc = r^2 holds except
 * for such errors.
 *
 * Perspective: across one axis of the image, say x, the sphere becomes a disc of radius R around
 * (x, z). With L^2 = x^2 + z^2, and T^2 = L^2 - R^2, the square of the length of a tangent from the
 * eye, the two tangents cross the image plane at
 *
 *     (x T - z R) / (z T + x R)    and    (x T + z R) / (z T - x R)
 *
 * unless their denominators are not positive; then the tangent does not meet the plane in front of
 * the eye, and the disc has no bound on that side. It has none if the eye is inside the disc. T^2
 * is reduced by 16 u L^2, which turns the tangents outwards by more than all rounding; what is left
 * is below 32 u (1 + s^2) at a bound s. So bounds are exact up to rounding, even if the sphere
 * crosses the plane through the eye.
 *
 * Parallel: the bounds are x - R and x + R.
 *
 * Spheres wholly at or behind the eye's plane, where z + R <= 0, are dropped.
 */
#ifndef lambent_SphereBoxKernel_h
#define lambent_SphereBoxKernel_h

#include "PointLattice.h"

#include <cstdint>

namespace lambent
{
struct SphereBoxes
{
  static constexpr int capacity = 64;
  static constexpr int room = capacity + 8; ///< a vector may reach beyond the last

  int count = 0;
  alignas(64) double centers[3][room] = {}; ///< in the world
  alignas(64) double radii[room] = {};

  // Output.
  /// Columns i0 to i1 - 1 and rows j0 to j1 - 1. A sphere without samples has an empty box.
  alignas(64) std::int32_t i0[room], i1[room], j0[room], j1[room];
  /// Not more than the depth of any hit. NaN if some number is not finite, or if squares overflow
  /// or underflow; then there is no box.
  alignas(64) double nearest[room];
};

/// Whether findSphereBoxes() applies: positions must be precise, and the image not so wide, seen
/// from the eye, that the errors above matter.
bool haveSphereBoxes(const PointLattice& lattice);

void findSphereBoxes(const PointLattice& lattice, SphereBoxes& boxes);
}

#endif
