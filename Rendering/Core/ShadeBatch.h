// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief some hits side by side, as the shading kernel wants them
 *
 * Hits come in order along rows, so neighbours often share their triangle. What
 * belongs to the triangle is kept once for each run of hits on the same one.
 */
#ifndef lambent_ShadeBatch_h
#define lambent_ShadeBatch_h

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace lambent
{
struct ShadeBatch
{
  static constexpr int capacity = 128;
  /// Vectors may reach beyond the last hit and the last run.
  static constexpr int room = capacity + 8;

  int count = 0; ///< of hits
  int runs = 0;  ///< of hits on the same triangle
  std::size_t pixels[room];
  std::int64_t run[room];        ///< of each hit
  std::uint32_t triangles[room]; ///< of each run

  double x[room], y[room]; ///< the ray of each hit

  /// Of each run: its triangle's corners ax, ay, az, bx, ... in the world, then in
  /// the camera's frame; and the normals at a, b, c, or that of the face.
  double points[9][room];
  double normals[9][room];

  /// The result: red, green and blue of each hit, and the same as bytes.
  double colors[3][room];
  std::int32_t bytes[3][room];

  bool hasRoomFor(int hits) const { return this->count + hits <= capacity; }

  /// Let the vector that the last hit is in be full, with copies of it.
  void fillUp()
  {
    std::fill_n(this->run + this->count, room - capacity, this->run[this->count - 1]);
    std::fill_n(this->x + this->count, room - capacity, this->x[this->count - 1]);
    std::fill_n(this->y + this->count, room - capacity, this->y[this->count - 1]);
  }

  void clear() { this->count = this->runs = 0; }
};

/// Some of a batch's runs, all on one surface, and their hits.
struct ShadeRange
{
  int firstRun = 0, endRun = 0;
  int first = 0, end = 0;
};
}

#endif
