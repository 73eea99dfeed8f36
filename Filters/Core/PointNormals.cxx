// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointNormals.h"

#include "CellBlocks.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace lambent
{
namespace
{
/// Into how many ranges to divide the points. Several for each worker even out the
/// work, but a block is walked once for each range that it touches: where blocks name
/// points from everywhere, one range for each worker is least.
std::size_t countRanges(
  const std::vector<CellBlock>& blocks, std::size_t pointCount, const Parallel& parallel)
{
  constexpr double rangesPerWorker = 4.0;
  constexpr double mostExtraVisits = 0.5; // per block
  const double workers = parallel.workers();
  double spread = 0.0; // the part of all points that lies between a block's first and last
  for (const CellBlock& block : blocks)
  {
    spread += static_cast<double>(std::max<std::int64_t>(block.lastPoint - block.firstPoint, 0)) /
      static_cast<double>(blocks.size() * pointCount);
  }
  const double ranges = spread > 0.0 ? std::floor(mostExtraVisits / spread) : workers;
  return static_cast<std::size_t>(
    workers > 1.0 ? std::clamp(ranges, workers, rangesPerWorker * workers) : 1.0);
}

/// What one worker sums up: the points begin to end - 1.
struct PointRange
{
  std::int64_t begin, end;
  std::vector<Vec3>& sums;

  template <typename Id>
  bool contains(Id point) const
  {
    return static_cast<std::uint64_t>(point - this->begin) <
      static_cast<std::uint64_t>(this->end - this->begin);
  }

  template <typename Id, typename Compute>
  void add(Id point, Compute&& compute) const
  {
    if (this->contains(point))
    {
      Vec3& sum = this->sums[static_cast<std::size_t>(point - this->begin)];
      sum = sum + compute();
    }
  }
};

template <Weighting weighting, typename Points, typename Id>
void addFace(const Points& points, const Id* corners, std::size_t size, std::vector<Id>& scratch,
  const PointRange& range)
{
  if (std::none_of(corners, corners + size, [&](Id point) { return range.contains(point); }))
  {
    return;
  }
  if (size == 3)
  {
    contributeTriangle<weighting>(points[corners[0]], points[corners[1]], points[corners[2]],
      [&](int i, auto&& compute) { range.add(corners[i], compute); });
  }
  else
  {
    contributePolygon<weighting>(
      points, corners, size, scratch, [&](Id point, auto&& compute) { range.add(point, compute); });
  }
}

void writeNormal(const Vec3& sum, float sign, float* normal)
{
  const bool isUsable = isUsableSquare(dot(sum, sum));
  const Vec3 unit = isUsable ? normalized(sum) : Vec3(0.0);
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = isUsable ? sign * static_cast<float>(unit[i]) : 0.0f; // never -0 for nothing
  }
}

template <Weighting weighting>
void sumUp(const Faces& faces, float sign, const Parallel& parallel, float* normals)
{
  const std::vector<CellBlock> blocks = findBlocks(faces.cells, parallel);
  const std::size_t ranges = countRanges(blocks, faces.points.size, parallel);
  std::vector<std::vector<Vec3>> sums(static_cast<std::size_t>(parallel.workers()));

  visit(faces.points, faces.cells,
    [&](auto points, auto cells)
    {
      using Id = std::decay_t<decltype(*cells.corners)>;
      forEach(parallel, 0, ranges,
        [&](int worker, std::size_t i)
        {
          const PointRange range{ static_cast<std::int64_t>(faces.points.size * i / ranges),
            static_cast<std::int64_t>(faces.points.size * (i + 1) / ranges), sums[worker] };
          range.sums.assign(static_cast<std::size_t>(range.end - range.begin), Vec3(0.0));
          std::vector<Id> scratch;
          for (const CellBlock& block : blocks)
          {
            if (!block.touches(range.begin, range.end))
            {
              continue;
            }
            for (std::size_t face = block.begin; face < block.end; ++face)
            {
              if (!faces.isSkipped(face))
              {
                addFace<weighting>(points, cells.cell(face), cells.cellSize(face), scratch, range);
              }
            }
          }
          for (std::size_t j = 0; j < range.sums.size(); ++j)
          {
            writeNormal(range.sums[j], sign, normals + 3 * (range.begin + j));
          }
        });
    });
}
}

void computePointNormals(
  const Faces& faces, Weighting weighting, float sign, const Parallel& parallel, float* normals)
{
  switch (weighting)
  {
    case Weighting::Uniform:
      return sumUp<Weighting::Uniform>(faces, sign, parallel, normals);
    case Weighting::Area:
      return sumUp<Weighting::Area>(faces, sign, parallel, normals);
    case Weighting::Angle:
      return sumUp<Weighting::Angle>(faces, sign, parallel, normals);
    case Weighting::Max:
      return sumUp<Weighting::Max>(faces, sign, parallel, normals);
  }
}

void computeFaceNormals(const Faces& faces, float sign, const Parallel& parallel, float* normals)
{
  visitFaceNormals(faces, parallel,
    [&](std::size_t face, const Vec3& normal) { writeNormal(normal, sign, normals + 3 * face); });
}
}
