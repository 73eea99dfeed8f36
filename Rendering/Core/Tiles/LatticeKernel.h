// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief PointLattice::locate() for many points, and the boxes of many triangles, at a time
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

/// The boxes of a batch of triangles.
struct LatticeBoxes
{
  static constexpr int capacity = 256;

  /// Input: three corners per triangle, as places among the positions.
  int count = 0;
  std::int32_t corners[3 * capacity];

  /// Output: first and end of each triangle's box, and whether the box is inexact.
  LatticePosition first[capacity], end[capacity];
  std::uint32_t isInexact[capacity];

  /// The triangles with a sample in their box, by their place in the batch.
  int found = 0;
  std::uint32_t triangles[capacity];

  /// The triangles with a point that is "anywhere" or "not finite".
  int unplaced = 0;
  std::uint32_t unplacedTriangles[capacity];
};

/// Adds the corners of the triangles [begin, end) of a surface. The positions of its points start
/// at `offset`; 32 bits must hold the last. Returns false and adds nothing if a corner is not below
/// pointCount.
bool addCorners(const IndexSpan& corners, std::size_t begin, std::size_t end,
  std::size_t pointCount, std::int32_t offset, LatticeBoxes& boxes);

/// Computes the output. The ends are those of samplesBetween() before groups of samples are
/// expanded.
void findBoxes(const LatticePosition* positions, LatticeBoxes& boxes);
}

#endif
