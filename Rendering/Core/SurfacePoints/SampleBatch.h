// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief some pieces of rows of samples, as the kernels for surface points and light take them
 *
 * Neighbours in a row often hit the same triangle, or nothing. What belongs to the
 * triangle is kept once for each run of samples that have it in common. Runs are numbered
 * on from piece to piece, without a gap.
 */
#ifndef lambent_SampleBatch_h
#define lambent_SampleBatch_h

#include "SceneMesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace lambent
{
/// Some neighbouring samples of a row.
struct SamplePiece
{
  int i, j; ///< the pixel of the first, in the image's part
  int width;
  const double* xs; ///< where they are on the image plane; a vector may read beyond the last
  double y;
};

struct SampleBatch
{
  static constexpr int pieceSize = 32;
  static constexpr int mostPieces = 4;
  /// Sample i of piece k has place k pieceSize + i.
  static constexpr int places = mostPieces * pieceSize;
  /// As many runs as places at the most; vectors may reach beyond the last.
  static constexpr int room = places + 8;

  int pieceCount = 0;
  int runCount = 0;
  SamplePiece pieces[mostPieces];
  std::int64_t run[places]; ///< of each sample

  // Of each run.
  std::uint32_t triangles[room]; ///< or noTriangle
  const SceneMesh::Part* parts[room];
  double isWanted[room] = {};   ///< 1 where the kernel shall shade it, 0 elsewhere
  double points[9][room] = {};  ///< corners ax, ay, az, bx, ... in the world, then in the frame
  double normals[9][room] = {}; ///< at a, b, c, or that of the face
  double reflection[6][room];   ///< diffuse, ambient; not where all of a range have the same

  /// Of each sample: red, green and blue.
  double colors[3][places];

  bool isFull() const { return this->pieceCount == mostPieces; }

  /// Add a piece with the triangles that its rays hit; false if they all hit nothing.
  bool add(const SamplePiece& piece, const std::uint32_t* hits)
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

/// Runs that are shaded alike, and the places of their samples.
struct RunRange
{
  int firstRun = 0, endRun = 0;
  int first = 0, end = 0;
  bool isUnlit = false;
  bool isSmooth = false;                  ///< normals at the corners, else one of the face
  bool hasGivenNormals = false;           ///< not just those of the triangles' geometry
  const SceneMesh::Part* part = nullptr;  ///< if it is the same for all
  const Appearance* appearance = nullptr; ///< if it is the same for all
};
}

#endif
