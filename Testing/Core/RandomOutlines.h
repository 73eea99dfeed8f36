// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief random plane outlines: simple ones, and changes that make them touch themselves
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

/// The closed outline of a plane region; corner k has the id ids[k]. A repeated corner can have the
/// same id or a new one.
struct Outline
{
  std::vector<PlanePoint> corners;
  std::vector<int> ids;
  int idCount = 0;

  std::size_t size() const { return this->corners.size(); }
  const PlanePoint& after(std::size_t k) const { return this->corners[(k + 1) % this->size()]; }

  /// Half the sum of the cross products of consecutive corners (the shoelace formula).
  double area() const;
  /// The winding number about a point.
  int winding(const PlanePoint& p) const;

  void insert(std::size_t at, const PlanePoint& corner, int id);
  /// Like insert(), with a new id.
  void insert(std::size_t at, const PlanePoint& corner);
};

/// Twice the signed area of a triangle.
double cross(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c);

/// An outline with corners at random distances in all directions.
Outline makeStar(RandomNumbers& random, int size);
/// An outline of random points of a small grid, without intersecting edges.
Outline makeMaze(RandomNumbers& random, int size);

/// Repeats a random corner, once or twice.
void doubleCorner(Outline& outline, RandomNumbers& random);
/// Inserts a corner in the middle of an edge.
void splitEdge(Outline& outline, RandomNumbers& random);
/// Inserts an edge to a random point, inside or outside, and back. The way there may be split.
void addSpike(Outline& outline, RandomNumbers& random);
/// Inserts a detour: back along an edge, and forward again.
void addDetour(Outline& outline, RandomNumbers& random);
/// Inserts a hole, connected to a corner by a slit.
void addHole(Outline& outline, RandomNumbers& random);
/// Inserts a hole that touches a corner.
void addTouchingHole(Outline& outline, RandomNumbers& random);
/// Rotates the outline to start at another corner, and may reverse it.
void turnRound(Outline& outline, RandomNumbers& random);

#endif
