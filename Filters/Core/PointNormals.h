// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the normal of each point: the sum of its faces' contributions, in the order of the faces
 *
 * The definition is a plain serial loop. The sum of a point starts at zero. The
 * contributions (NormalContribution.h) are added in binary64, in ascending order of face
 * and of corner within the face. The sum, divided by its length, is rounded to float. A sum
 * whose squared length is zero, subnormal or not finite gives (0, 0, 0).
 *
 * The parallel algorithm gives the same bits with any number of workers:
 *
 * 1. Divide the points into ranges of consecutive ids. Each range belongs to one worker,
 *    which keeps sums for these points only.
 * 2. For its range, a worker walks all blocks of faces in ascending order, skips those
 *    without points in the range, and adds the contributions to points in the range.
 * 3. It normalizes the sums of its range.
 *
 * Blocks that contain only triangles use NormalKernel.h, several triangles at a time. All
 * other blocks go one face at a time, and so do all blocks if a face is skipped or the vector
 * target is "plain".
 *
 * No sum is shared, so nothing is locked, and each sum receives its terms in the order of
 * the serial loop. The price is that a face with corners in two ranges is computed twice.
 * Neighbouring faces usually have neighbouring point ids, so there are few such faces.
 */
#ifndef lambent_PointNormals_h
#define lambent_PointNormals_h

#include "CellBlocks.h"
#include "CellView.h"
#include "Chunks.h"
#include "NormalContribution.h"
#include "Parallel.h"

#include <vector>

namespace lambent
{
/// The faces of a mesh. All ids must be valid.
struct Faces
{
  TupleSpan points;
  CellSpan cells;
  /// The blocks of these cells, from checkCells().
  std::vector<CellBlock> blocks;
  /// Nonzero for a face to ignore. Empty: ignore none.
  std::vector<unsigned char> skip;

  bool isSkipped(std::size_t face) const { return !this->skip.empty() && this->skip[face] != 0; }
};

/// Calls body(face, unit normal or zero) for each face, in any order.
template <typename Body>
void visitFaceNormals(const Faces& faces, const Parallel& parallel, Body&& body)
{
  constexpr std::size_t facesPerChunk = 4096;
  visit(faces.points, faces.cells,
    [&](auto points, auto cells)
    {
      forEachChunk<facesPerChunk>(parallel, cellCount(faces.cells),
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t face = begin; face < end; ++face)
          {
            body(face,
              faces.isSkipped(face) ? Vec3(0.0)
                                    : faceNormal(points, cells.cell(face), cells.cellSize(face)));
          }
        });
    });
}

/// Writes three floats for each point: its normal times sign (1 or -1), or (0, 0, 0).
void computePointNormals(
  const Faces& faces, Weighting weighting, float sign, const Parallel& parallel, float* normals);

/// Writes three floats for each face: its unit normal times sign, or (0, 0, 0).
void computeFaceNormals(const Faces& faces, float sign, const Parallel& parallel, float* normals);
}

#endif
