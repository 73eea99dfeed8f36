// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief shapes whose coordinates have the same bits on every platform
 *
 * They use integers, seeded generators, and + - * / sqrt in a fixed order, but nothing else
 * of the platform's libm. Circles have rational points; balls are subdivided octahedra.
 */
#ifndef Shapes_h
#define Shapes_h

#include "ImageContract.h"

#include "../Core/RandomNumbers.h"

#include <cstdint>
#include <vector>

using lambent::Vec3;

struct Shape
{
  std::vector<Vec3> points;
  std::vector<std::vector<std::int64_t>> cells;

  /// Adds a triangle with its own points.
  void add(const Vec3& a, const Vec3& b, const Vec3& c);
};

Shape triangle(const Vec3& a, const Vec3& b, const Vec3& c);

/// Six quads that face outwards and share corners.
Shape box(const Vec3& half);

/// The unit sphere: an octahedron whose triangles are divided into four `levels` times; closed,
/// with shared points, each of which is its own normal.
Shape ball(int levels);

/// The square |x|, |y| <= 1 at z = 0, of n x n quads.
Shape square(int n);

/// 2 n x n triangles over the same square, as hills of height up to 1/4.
Shape hills(int n);

/// The lateral surface of a cylinder of radius 1, |y| <= 1, of 4 n quads.
Shape cylinder(int n);

/// A concave polygon with 2 n points in the plane z = 0.
Shape star(int n);

/// The unit square as n strips of 2 n triangles each; the cells are strips.
Shape ribbons(int n);

/// Triangles of about this size, at random places in |x|, |y|, |z| <= 1.
Shape soup(RandomNumbers& random, int count, double size);

/// Thin triangles of this width between random places.
Shape needles(RandomNumbers& random, int count, double width);

/// Parallel squares, from z = 1/2 to z = -1/2.
Shape layers(int count);

Shape scaled(Shape shape, const Vec3& factors);
Shape moved(Shape shape, const Vec3& by);

/// The same faces, reversed.
Shape turned(Shape shape);

/// The same triangles without shared points.
Shape apart(const Shape& shape);

/// Both shapes as one.
Shape joined(Shape a, const Shape& b);

#endif
