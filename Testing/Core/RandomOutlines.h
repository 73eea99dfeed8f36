// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief random plane outlines: simple ones, and what makes them touch themselves
 *
 * Coordinates are multiples of 2^-16, so that the middle of an edge lies exactly on it.
 */
#ifndef RandomOutlines_h
#define RandomOutlines_h

#include "RandomNumbers.h"

#include <cstddef>
#include <vector>

struct PlanePoint
{
  double x, y;
};

/// The closed outline of a plane region; corner k has the id ids[k]. A corner that is
/// named again has the id that it had, or a new one.
struct Outline
{
  std::vector<PlanePoint> corners;
  std::vector<int> ids;
  int idCount = 0;

  std::size_t size() const { return this->corners.size(); }
  const PlanePoint& after(std::size_t k) const { return this->corners[(k + 1) % this->size()]; }

  /// Half of the sum of the cross products of its corners (the shoelace formula).
  double area() const;
  /// How often it runs round a point.
  int winding(const PlanePoint& p) const;

  void insert(std::size_t at, const PlanePoint& corner, int id);
  /// As insert(), with a new id.
  void insert(std::size_t at, const PlanePoint& corner);
};

/// Twice the signed area of a triangle.
double cross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

/// Corners at random distances in all directions.
Outline makeStar(RandomNumbers& random, int size);
/// Random points of a small grid, joined so that no two edges meet.
Outline makeMaze(RandomNumbers& random, int size);

/// Name some corner once more, and maybe again.
void doubleCorner(Outline& outline, RandomNumbers& random);
/// A corner in the middle of an edge.
void splitEdge(Outline& outline, RandomNumbers& random);
/// An edge to somewhere and back, inside or outside, of one or more pieces.
void addSpike(Outline& outline, RandomNumbers& random);
/// Back along an edge, and forth again.
void addDetour(Outline& outline, RandomNumbers& random);
/// A hole, with a slit from a corner to it.
void addHole(Outline& outline, RandomNumbers& random);
/// A hole that touches a corner.
void addTouchingHole(Outline& outline, RandomNumbers& random);
/// The same from another corner on, and maybe the other way round.
void turnRound(Outline& outline, RandomNumbers& random);

#endif
