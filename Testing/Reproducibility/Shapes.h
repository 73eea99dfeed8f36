// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief shapes whose coordinates are the same bits on every platform
 *
 * Whole numbers, seeded generators, and + - * / sqrt in one written order; nothing
 * of the platform's libm. Circles have rational points, balls are subdivided
 * octahedra.
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

  /// A triangle with points of its own.
  void add(const Vec3& a, const Vec3& b, const Vec3& c);
};

Shape triangle(const Vec3& a, const Vec3& b, const Vec3& c);

/// Six quads that face outwards and share their corners.
Shape box(const Vec3& half);

/// The unit sphere: an octahedron, its triangles cut in four so many times; closed,
/// with shared points, each of which is its own normal.
Shape ball(int levels);

/// The square |x|, |y| <= 1 at z = 0, of n x n quads.
Shape square(int n);

/// Twice n x n triangles over that square, on hills of height up to 1/4.
Shape hills(int n);

/// The mantle of a cylinder of radius 1, |y| <= 1, of 4 n quads.
Shape cylinder(int n);

/// A concave polygon of 2 n points in the plane z = 0.
Shape star(int n);

/// The unit square as n strips of 2 n triangles each; cells are strips.
Shape ribbons(int n);

/// Triangles of a size, anywhere in |x|, |y|, |z| <= 1.
Shape soup(RandomNumbers& random, int count, double size);

/// Triangles from anywhere to anywhere, of a width.
Shape needles(RandomNumbers& random, int count, double width);

/// Squares one behind the other, from z = 1/2 to z = -1/2.
Shape layers(int count);

Shape scaled(Shape shape, const Vec3& factors);
Shape moved(Shape shape, const Vec3& by);

/// The same faces the other way round.
Shape turned(Shape shape);

/// The same triangles with no point shared.
Shape apart(const Shape& shape);

/// Both of them.
Shape joined(Shape a, const Shape& b);

#endif
