// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SmallTriangleBinning.h"

namespace lambent
{
namespace
{
/// Copies the corners of the triangles [begin, end). The loop is short so that the processor can
/// fetch the points of several triangles at a time.
template <typename Coordinate>
void loadCorners(
  const SmallTriangles& small, int begin, int end, const Coordinate* points, CoverageBatch& batch)
{
  for (int k = begin; k < end; ++k)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const Coordinate* point =
        points + 3 * static_cast<std::size_t>(small.items[k].corners[corner]);
      batch.points[3 * corner][k] = point[0];
      batch.points[3 * corner + 1][k] = point[1];
      batch.points[3 * corner + 2][k] = point[2];
    }
  }
}

void loadCorners(
  const SmallTriangles& small, int begin, int end, const TupleSpan& points, CoverageBatch& batch)
{
  points.isDouble ? loadCorners(small, begin, end, static_cast<const double*>(points.data), batch)
                  : loadCorners(small, begin, end, static_cast<const float*>(points.data), batch);
}
}

void SmallTriangleBinning::flush(SmallTriangleMemory& memory, BinningResult& result) const
{
  for (int height = 1; height <= SmallTriangles::side; ++height)
  {
    for (int width = 1; width <= SmallTriangles::side; ++width)
    {
      if (memory.queues[height - 1][width - 1].count > 0)
      {
        this->flush(width, height, memory, result);
      }
    }
  }
  memory.part = nullptr;
  memory.isMixed = false;
}

void SmallTriangleBinning::load(int width, int height, SmallTriangleMemory& memory) const
{
  const SmallTriangles& small = memory.queues[height - 1][width - 1];
  CoverageBatch& batch = memory.batch;
  batch.count = small.count;
  batch.width = width;
  batch.height = height;
  for (int k = 0; k < small.count; ++k)
  {
    batch.triangles[k] = small.items[k].number;
    batch.i[k] = small.items[k].first.column;
    batch.j[k] = small.items[k].first.row;
  }
  if (!memory.isMixed)
  {
    loadCorners(small, 0, small.count, memory.part->points(), batch);
    return;
  }
  for (int k = 0; k < small.count; ++k)
  {
    loadCorners(small, k, k + 1, this->Mesh.mesh().partOf(small.items[k].number).points(), batch);
  }
}

void SmallTriangleBinning::flush(
  int width, int height, SmallTriangleMemory& memory, BinningResult& result) const
{
  SmallTriangles& small = memory.queues[height - 1][width - 1];
  CoveredSamples& covered = memory.covered;
  this->load(width, height, memory);
  const CoverageBatch& batch = memory.batch;
  findCoverage(batch, this->Lattice, covered);
  small.count = 0;
  result.bins.insertHits(covered.certain,
    [&](int k) -> Bins::SampleHit
    {
      const CoveredSample sample = covered.certainSamples[k];
      const int t = sample.triangle();
      return { batch.i[t] + sample.i(), batch.j[t] + sample.j(), batch.triangles[t],
        { covered.lows[t], covered.highs[t] } };
    });
  for (int k = 0; k < covered.uncertain; ++k)
  {
    const CoveredSample& sample = covered.uncertainSamples[k];
    const int t = sample.triangle();
    const std::uint32_t triangle = batch.triangles[t];
    const int i = batch.i[t] + sample.i(), j = batch.j[t] + sample.j();
    double depth;
    if (this->Mesh.hits(
          triangle, this->Frame.x(this->Part.i0 + i), this->Frame.y(this->Part.j0 + j), depth))
    {
      result.bins.insertHit({ i, j, triangle, nearnessOf(depth, this->Frame.parallel) });
    }
  }
}
}
