// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the surface points of the samples of a batch that see lines
 *
 * One sample at a time, with the definition, LinePoints::at(). A line is projected once for each
 * run.
 */
#ifndef lambent_LineBatch_h
#define lambent_LineBatch_h

#include "PointBatch.h"
#include "RunRange.h"
#include "SurfacePoints.h"

namespace lambent
{
/// Calls keep(place, point) for the samples of a range of lines.
template <typename Keep>
void forLinePoints(
  const SurfacePoints& points, const RunRange& range, const SampleBatch& batch, const Keep& keep)
{
  const FrameMesh& mesh = points.lines().mesh();
  for (int begin = range.first, next = 0; begin < range.end; begin = next)
  {
    next = batch.endOfRun(begin, range.end);
    const std::int64_t run = batch.run[begin];
    const std::uint32_t number = batch.primitives[run];
    if (number == noPrimitive)
    {
      continue;
    }
    const SceneMesh::Part& part = *batch.parts[run];
    const FrameLine line = mesh.line(part, number);
    for (int place = begin; place < next; ++place)
    {
      const SamplePiece& piece = batch.pieces[place / SampleBatch::pieceSize];
      const int i = place % SampleBatch::pieceSize;
      if (i < piece.width)
      {
        keep(place, points.lines().at(part, number, line, piece.xs[i], piece.y));
      }
    }
  }
}

/// Stores a surface point in a batch, as kernels do.
inline void store(const SurfacePoint& point, const Vec3& eye, PointBatch& batch, int place)
{
  const Vec3 normal = normalized(point.normal), position = eye + point.position;
  batch.depth[place] = point.depth;
  for (int k = 0; k < 3; ++k)
  {
    batch.normal[k][place] = normal[k];
    batch.position[k][place] = position[k];
    batch.weights[k][place] = point.weights[k];
  }
}

/// Fills in the surface points of a range of lines.
inline void computeLinePoints(
  const SurfacePoints& points, const RunRange& range, const SampleBatch& batch, PointBatch& result)
{
  forLinePoints(points, range, batch,
    [&](int place, const SurfacePoint& point) { store(point, points.eye(), result, place); });
}
}

#endif
