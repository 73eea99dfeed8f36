// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the normal of each point: what its faces add, in the order of the faces
 *
 * The definition is a plain serial loop: the sum of a point starts at zero, and
 * the contributions (NormalContribution.h) are added in binary64 in ascending order
 * of face and of corner within the face; the sum over its length is rounded to
 * float. A sum whose squared length is zero or not finite gives (0, 0, 0).
 *
 * How it runs on any number of workers and gives those bits:
 *
 * 1. The points are divided into ranges of consecutive ids, each the business of
 *    one worker, which has sums for these points only.
 * 2. For its range a worker walks all blocks of faces in ascending order, skips
 *    those that name none of its points, and adds what falls into the range.
 * 3. It scales the sums of its range to length one.
 *
 * Blocks of nothing but triangles go through NormalKernel.h, several triangles at a
 * time; all else, and everything where no vectors are wanted, one face at a time.
 *
 * No sum is shared, so nothing is locked, and each sum sees its terms in the order
 * of the serial loop. The price is that a face that has corners in two ranges is
 * computed twice; meshes name neighbouring points in neighbouring faces, so few are.
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
  /// Of these cells, as checkCells() gives them.
  std::vector<CellBlock> blocks;
  /// Not 0 for a face that counts for nothing; empty: all count.
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

/// Writes three floats for each point, multiplied with sign, 1 or -1.
void computePointNormals(
  const Faces& faces, Weighting weighting, float sign, const Parallel& parallel, float* normals);

/// Writes three floats for each face: its unit normal times sign, or (0, 0, 0).
void computeFaceNormals(const Faces& faces, float sign, const Parallel& parallel, float* normals);
}

#endif
