// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief PointLattice for many points, and its boxes for many triangles, at a time
 */
#ifndef lambent_LatticeKernel_h
#define lambent_LatticeKernel_h

#include "PointLattice.h"
#include "Scene.h"

namespace lambent
{
/// PointLattice::locate() for the points [begin, end).
void locatePoints(const PointLattice& lattice, const TupleSpan& points, std::size_t begin,
  std::size_t end, LatticePosition* positions);

/// The boxes of some triangles.
struct LatticeBoxes
{
  static constexpr int capacity = 256;

  /// Going in: the corners of each triangle, three after three, as places among the positions.
  int count = 0;
  std::int32_t corners[3 * capacity];

  /// Coming out: the ends of each triangle's box, and whether it is inexact.
  LatticePosition first[capacity], end[capacity];
  std::uint32_t isInexact[capacity];

  /// The triangles with a ray in their box, by their place among those that went in.
  int found = 0;
  std::uint32_t triangles[capacity];

  /// And those with a point that is anywhere or not finite.
  int unplaced = 0;
  std::uint32_t unplacedTriangles[capacity];
};

/// Add the corners of the triangles [begin, end) of a surface, whose points are at offset and
/// after it; 32 bits must hold the last. False, and nothing added, if a corner is not below
/// pointCount.
bool addCorners(const IndexSpan& corners, std::size_t begin, std::size_t end,
  std::size_t pointCount, std::int32_t offset, LatticeBoxes& boxes);

/// Fill in what comes out. The ends are those that raysBetween() would give, before
/// groups of rays are taken apart.
void findBoxes(const LatticePosition* positions, LatticeBoxes& boxes);
}

#endif
