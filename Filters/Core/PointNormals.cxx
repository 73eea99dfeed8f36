// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointNormals.h"

#include "NormalKernel.h"
#include "PointSums.h"
#include "VectorTarget.h"

#include <algorithm>
#include <type_traits>

namespace lambent
{
namespace
{
/// Where range i of several begins.
std::int64_t rangeBegin(std::size_t pointCount, std::size_t i, std::size_t ranges)
{
  return static_cast<std::int64_t>(pointCount * i / ranges);
}

/// How often a block is walked on average.
double visitsPerBlock(
  const std::vector<CellBlock>& blocks, std::size_t pointCount, std::size_t ranges)
{
  std::size_t visits = 0;
  for (std::size_t i = 0; i < ranges; ++i)
  {
    visits += static_cast<std::size_t>(std::count_if(blocks.begin(), blocks.end(),
      [&](const CellBlock& block)
      {
        return block.touches(
          rangeBegin(pointCount, i, ranges), rangeBegin(pointCount, i + 1, ranges));
      }));
  }
  return static_cast<double>(visits) / static_cast<double>(std::max<std::size_t>(blocks.size(), 1));
}

/// Into how many ranges to divide the points. Several for each worker even out the
/// work and keep the sums in the cache, but a block is walked once for each range that
/// it touches: where blocks name points from everywhere, one range for each worker is
/// least.
std::size_t countRanges(
  const std::vector<CellBlock>& blocks, std::size_t pointCount, const Parallel& parallel)
{
  constexpr double mostVisitsPerBlock = 1.6;
  const auto workers = static_cast<std::size_t>(parallel.workers());
  std::size_t ranges = 4 * workers;
  while (ranges > workers && visitsPerBlock(blocks, pointCount, ranges) > mostVisitsPerBlock)
  {
    ranges /= 2;
  }
  return ranges;
}

template <Weighting weighting, typename Points, typename Id>
void addFace(const Points& points, const Id* corners, std::size_t size, std::vector<Id>& scratch,
  PointSums& sums)
{
  if (std::all_of(
        corners, corners + size, [&](Id point) { return sums.place(point) == sums.size(); }))
  {
    return;
  }
  if (size == 3)
  {
    contributeTriangle<weighting>(points[corners[0]], points[corners[1]], points[corners[2]],
      [&](int i, const Vec3& term) { sums.add(corners[i], term); });
  }
  else
  {
    contributePolygon<weighting>(
      points, corners, size, scratch, [&](Id point, const Vec3& term) { sums.add(point, term); });
  }
}

/// Goes through the faces for one range of points after the other.
template <Weighting weighting, typename Points, typename Cells>
class Summation
{
public:
  Summation(const Faces& faces, const Points& points, const Cells& cells)
    : AllFaces(faces)
    , AllPoints(points)
    , AllCells(cells)
  {
  }

  void addUp(PointSums& sums, bool useKernels) const
  {
    std::vector<std::decay_t<decltype(*this->AllCells.corners)>> scratch;
    const std::int64_t end = sums.begin() + static_cast<std::int64_t>(sums.size());
    for (const CellBlock& block : this->AllFaces.blocks)
    {
      if (!block.touches(sums.begin(), end))
      {
        continue;
      }
      std::size_t face = block.begin;
      if (useKernels && block.hasOnlyTriangles && this->AllFaces.skip.empty())
      {
        face += addTriangles(weighting, this->AllFaces.points, this->AllCells.cell(face),
          block.end - block.begin, sums);
      }
      for (; face < block.end; ++face)
      {
        if (!this->AllFaces.isSkipped(face))
        {
          addFace<weighting>(this->AllPoints, this->AllCells.cell(face),
            this->AllCells.cellSize(face), scratch, sums);
        }
      }
    }
  }

private:
  const Faces& AllFaces;
  const Points& AllPoints;
  const Cells& AllCells;
};

void writeNormal(const Vec3& sum, float sign, float* normal)
{
  const double square = dot(sum, sum);
  const bool isUsable = isUsableSquare(square);
  const Vec3 unit = isUsable ? sum * (1.0 / std::sqrt(square)) : Vec3(0.0);
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = isUsable ? sign * static_cast<float>(unit[i]) : 0.0f; // never -0 for nothing
  }
}

void writeNormals(const PointSums& sums, float sign, bool useKernels, float* normals)
{
  normals += 3 * sums.begin();
  std::size_t i = useKernels ? writeNormals(sums.data(), sums.size(), sign, normals) : 0;
  for (; i < sums.size(); ++i)
  {
    const PointSum& sum = sums.data()[i];
    writeNormal({ sum.x, sum.y, sum.z }, sign, normals + 3 * i);
  }
}

template <Weighting weighting>
void sumUp(const Faces& faces, float sign, const Parallel& parallel, float* normals)
{
  const bool useKernels = areVectorsInUse();
  const std::size_t ranges = countRanges(faces.blocks, faces.points.size, parallel);
  std::vector<PointSums> sums(static_cast<std::size_t>(parallel.workers()));
  visit(faces.points, faces.cells,
    [&](auto points, auto cells)
    {
      const Summation<weighting, decltype(points), decltype(cells)> summation(faces, points, cells);
      forEach(parallel, 0, ranges,
        [&](int worker, std::size_t i)
        {
          sums[worker].reset(
            rangeBegin(faces.points.size, i, ranges), rangeBegin(faces.points.size, i + 1, ranges));
          summation.addUp(sums[worker], useKernels);
          writeNormals(sums[worker], sign, useKernels, normals);
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
