// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief pieces of rows of samples, in the layout of the kernels for surface points and light
 *
 * Neighbours in a row often hit the same primitive, or nothing. So the data of a primitive is
 * stored once for each run of samples that share it. Runs are numbered consecutively over all
 * pieces.
 */
#ifndef lambent_SampleBatch_h
#define lambent_SampleBatch_h

#include "SceneMesh.h"

#include <algorithm>
#include <cstdint>

namespace lambent
{
/// Neighbouring samples of a row.
struct SamplePiece
{
  int i, j; ///< the first sample, counted in the part of the image
  int width;
  const double* xs; ///< positions on the image plane; a vector may read beyond the last
  double y;
};

struct SampleBatch
{
  static constexpr int pieceSize = 32;
  static constexpr int mostPieces = 4;
  /// Sample i of piece k has place k pieceSize + i.
  static constexpr int places = mostPieces * pieceSize;
  /// There are at most as many runs as places. Vectors may reach beyond the last run.
  static constexpr int room = places + 8;

  int pieceCount = 0;
  int runCount = 0;
  SamplePiece pieces[mostPieces];
  bool hasMisses[mostPieces];           ///< some samples of the piece hit nothing
  alignas(64) std::int64_t run[places]; ///< the run of each sample

  // One value per run.
  std::uint32_t primitives[room]; ///< or noPrimitive
  const SceneMesh::Part* parts[room];
  /// 1 where the kernel must shade the run, 0 elsewhere.
  alignas(64) double isWanted[room] = {};
  /// Corners ax, ay, az, bx, ... in the world, then in the frame.
  alignas(64) double points[9][room] = {};
  /// At a, b and c, or one of the face.
  alignas(64) double normals[9][room] = {};

  // Colours of a range that has several, by its ColorSource.
  /// Primitive: SurfaceColor of each run.
  alignas(64) double diffuse[3][room] = {};
  alignas(64) double ambient[3][room] = {};
  /// Interpolated: the colours at a, b and c. MappedLast: the numbers there, in rows 0, 3 and 6.
  alignas(64) double cornerColors[9][room] = {};
  /// Interpolated and MappedLast: what the colour is multiplied by, for diffuse and ambient.
  alignas(64) double coefficients[2][room] = {};

  // One value per sample.
  /// Barycentric coordinates of samples that hit a surface with a texture.
  alignas(64) double weights[3][places] = {};
  double textureAlphas[places] = {}; ///< 1 where the texture's alpha is not used
  /// Red, green and blue, and alpha if the image has it.
  alignas(64) double colors[4][places] = {};

  bool isHit(int place) const { return this->primitives[this->run[place]] != noPrimitive; }
  bool isFull() const { return this->pieceCount == mostPieces; }

  /// Adds a piece with the primitives that its rays hit. Returns false if they all hit nothing.
  bool add(const SamplePiece& piece, const std::uint32_t* hits)
  {
    std::uint32_t differences = 0, misses = 0;
    for (int i = 0; i < piece.width; ++i)
    {
      differences |= hits[i] ^ hits[0];
      misses |= hits[i] == noPrimitive ? 1 : 0;
    }
    if (hits[0] == noPrimitive && differences == 0)
    {
      return false;
    }
    this->hasMisses[this->pieceCount] = misses != 0;
    differences == 0 ? this->addRun(hits[0]) : this->addRuns(hits, piece.width);
    this->pieces[this->pieceCount++] = piece;
    return true;
  }

  /// The end of the places from `begin` on, and before `end`, that belong to the same run.
  int endOfRun(int begin, int end) const
  {
    int next = begin + 1;
    while (next < end && this->run[next] == this->run[begin])
    {
      ++next;
    }
    return next;
  }

  void clear() { this->pieceCount = this->runCount = 0; }

private:
  void addRun(std::uint32_t primitive)
  {
    this->primitives[this->runCount] = primitive;
    std::fill_n(this->run + this->pieceCount * pieceSize, pieceSize, this->runCount++);
  }

  void addRuns(const std::uint32_t* hits, int width)
  {
    std::int64_t* const runs = this->run + this->pieceCount * pieceSize;
    // The ends of runs are unpredictable, so all is written without branches.
    int last = this->runCount - 1;
    std::uint32_t primitive = ~hits[0];
    for (int i = 0; i < width; ++i)
    {
      last += hits[i] != primitive;
      primitive = hits[i];
      this->primitives[last] = primitive;
      runs[i] = last;
    }
    std::fill(runs + width, runs + pieceSize, last);
    this->runCount = last + 1;
  }
};
}

#endif
