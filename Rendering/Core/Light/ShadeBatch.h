// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief some pieces of rows of rays, as the shading kernel wants them
 *
 * Neighbours in a row often hit the same triangle, or nothing. What belongs to the
 * triangle is kept once for each run of rays that have it in common. Runs are numbered
 * on from piece to piece, without a gap.
 */
#ifndef lambent_ShadeBatch_h
#define lambent_ShadeBatch_h

#include "SceneMesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace lambent
{
/// Some neighbouring rays of a row.
struct RayPiece
{
  int i, j; ///< the pixel of the first, in the image's part
  int width;
  const double* xs; ///< where they are on the image plane; a vector may read beyond the last
  double y;
};

struct ShadeBatch
{
  static constexpr int pieceSize = 32;
  static constexpr int mostPieces = 4;
  /// Ray i of piece k has place k pieceSize + i.
  static constexpr int places = mostPieces * pieceSize;
  /// As many runs as places at the most; vectors may reach beyond the last.
  static constexpr int room = places + 8;

  int pieceCount = 0;
  int runCount = 0;
  RayPiece pieces[mostPieces];
  std::int64_t run[places]; ///< of each ray

  /// Of each run: its triangle or none; 1 where the kernel shall shade it, 0 elsewhere;
  /// the corners ax, ay, az, bx, ... in the world, then in the camera's frame; and the
  /// normals at a, b, c, or that of the face.
  std::uint32_t triangles[room];
  double isWanted[room] = {};
  double points[9][room] = {};
  double normals[9][room] = {};

  /// Of each ray: red, green and blue.
  double colors[3][places];

  bool isFull() const { return this->pieceCount == mostPieces; }

  /// Take up a piece with the triangles that its rays hit; not if they all hit nothing.
  bool add(const RayPiece& piece, const std::uint32_t* hits)
  {
    std::uint32_t differences = 0;
    for (int i = 0; i < piece.width; ++i)
    {
      differences |= hits[i] ^ hits[0];
    }
    if (hits[0] == noTriangle && differences == 0)
    {
      return false;
    }
    const int first = this->pieceCount * pieceSize;
    // Where runs end is a toss-up: all is written, without a branch.
    int last = this->runCount - 1;
    std::uint32_t triangle = ~hits[0];
    for (int i = 0; i < piece.width; ++i)
    {
      last += hits[i] != triangle;
      triangle = hits[i];
      this->triangles[last] = triangle;
      this->run[first + i] = last;
    }
    std::fill(this->run + first + piece.width, this->run + first + pieceSize, last);
    this->pieces[this->pieceCount++] = piece;
    this->runCount = last + 1;
    return true;
  }

  void clear() { this->pieceCount = this->runCount = 0; }
};

/// Runs that hit one surface, or nothing, and the places of their rays.
struct ShadeRange
{
  int firstRun = 0, endRun = 0;
  int first = 0, end = 0;
};
}

#endif
