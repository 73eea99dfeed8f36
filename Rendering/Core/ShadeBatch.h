// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief some hits on one surface side by side, as the shading kernel wants them
 *
 * Hits come in order along rows, so neighbours often share their triangle. What
 * belongs to the triangle is kept once for each run of hits on the same one.
 */
#ifndef lambent_ShadeBatch_h
#define lambent_ShadeBatch_h

#include <cstddef>
#include <cstdint>

namespace lambent
{
struct ShadeBatch
{
  static constexpr int capacity = 128;

  int count = 0; ///< of hits
  int runs = 0;  ///< of hits on the same triangle
  std::size_t pixels[capacity];
  std::int64_t run[capacity];        ///< of each hit
  std::uint32_t triangles[capacity]; ///< of each run

  alignas(64) double x[capacity], y[capacity]; ///< the ray of each hit

  /// Of each run: its triangle's corners ax, ay, az, bx, ... in the world, then in
  /// the camera's frame; and the normals at a, b, c, or that of the face.
  alignas(64) double points[9][capacity];
  alignas(64) double normals[9][capacity];

  /// The result: red, green and blue of each hit, and the same as bytes.
  alignas(64) double colors[3][capacity];
  alignas(64) std::int32_t bytes[3][capacity];

  bool isFull() const { return this->count == capacity; }

  /// The hits that are added from now on are on this triangle.
  void beginRun(std::uint32_t triangle) { this->triangles[this->runs++] = triangle; }

  void add(std::size_t pixel, double rayX, double rayY)
  {
    const int k = this->count++;
    this->pixels[k] = pixel;
    this->run[k] = this->runs - 1;
    this->x[k] = rayX;
    this->y[k] = rayY;
  }

  void clear() { this->count = this->runs = 0; }
};
}

#endif
