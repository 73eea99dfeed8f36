// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointNormals.h"

#include "NormalKernel.h"
#include "PointSums.h"
#include "VectorTarget.h"

#include <algorithm>
#include <atomic>
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

/// Adds the faces of a block to the sums of a range of points.
template <Weighting weighting, typename Points, typename Cells>
void addBlock(const Faces& faces, const Points& points, const Cells& cells, const CellBlock& block,
  bool useKernels, PointSums& sums)
{
  std::size_t face = block.begin;
  if (useKernels && block.hasOnlyTriangles && faces.skip.empty())
  {
    face += addTriangles(weighting, faces.points, cells.cell(face), block.end - block.begin, sums);
  }
  std::vector<std::decay_t<decltype(*cells.corners)>> scratch;
  for (; face < block.end; ++face)
  {
    if (!faces.isSkipped(face))
    {
      addFace<weighting>(points, cells.cell(face), cells.cellSize(face), scratch, sums);
    }
  }
}

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

/// Step 2 and 3 of the header, by all workers. Each stops now and then, wherever it is on
/// its way through the blocks, so that there can be a checkpoint.
template <Weighting weighting, typename Points, typename Cells>
class Summation
{
public:
  Summation(const Faces& faces, const Points& points, const Cells& cells, float sign,
    const Parallel& parallel, float* normals)
    : AllFaces(faces)
    , AllPoints(points)
    , AllCells(cells)
    , Sign(sign)
    , Workers(parallel)
    , Normals(normals)
    , Ranges(countRanges(faces.blocks, faces.points.size, parallel))
    , Walks(static_cast<std::size_t>(parallel.workers()))
  {
  }

  void run()
  {
    while (this->FinishedRanges < this->Ranges)
    {
      forEach(this->Workers, 0, this->Walks.size(),
        [this](int, std::size_t i) { this->goOn(this->Walks[i]); });
      this->Workers.checkpoint(this->done());
    }
  }

private:
  /// Through all blocks for one range of points. In a cache line of its own, since it is
  /// written to all the time.
  struct alignas(64) Walk
  {
    PointSums sums;
    bool hasRange = false;
    std::size_t nextBlock = 0;
  };

  void goOn(Walk& walk)
  {
    std::size_t faces = 0;
    while (faces < itemsPerPart && (walk.hasRange || this->takeRange(walk)))
    {
      if (walk.nextBlock == this->AllFaces.blocks.size())
      {
        this->finish(walk);
        continue;
      }
      const CellBlock& block = this->AllFaces.blocks[walk.nextBlock++];
      if (block.touches(walk.sums.begin(), walk.sums.end()))
      {
        addBlock<weighting>(
          this->AllFaces, this->AllPoints, this->AllCells, block, this->UseKernels, walk.sums);
        faces += block.end - block.begin;
      }
    }
  }

  bool takeRange(Walk& walk)
  {
    const std::size_t range = this->NextRange++;
    walk.hasRange = range < this->Ranges;
    if (walk.hasRange)
    {
      const std::size_t points = this->AllFaces.points.size;
      walk.sums.reset(
        rangeBegin(points, range, this->Ranges), rangeBegin(points, range + 1, this->Ranges));
    }
    return walk.hasRange;
  }

  void finish(Walk& walk)
  {
    writeNormals(walk.sums, this->Sign, this->UseKernels, this->Normals);
    walk.hasRange = false;
    walk.nextBlock = 0;
    ++this->FinishedRanges;
  }

  double done() const
  {
    double ranges = static_cast<double>(this->FinishedRanges);
    for (const Walk& walk : this->Walks)
    {
      ranges +=
        static_cast<double>(walk.nextBlock) / static_cast<double>(this->AllFaces.blocks.size() + 1);
    }
    return ranges / static_cast<double>(this->Ranges);
  }

  const Faces& AllFaces;
  const Points& AllPoints;
  const Cells& AllCells;
  const float Sign;
  const Parallel& Workers;
  float* const Normals;
  const bool UseKernels = areVectorsInUse();
  const std::size_t Ranges;
  std::vector<Walk> Walks; ///< one a worker
  std::atomic<std::size_t> NextRange{ 0 };
  std::atomic<std::size_t> FinishedRanges{ 0 };
};

template <Weighting weighting>
void sumUp(const Faces& faces, float sign, const Parallel& parallel, float* normals)
{
  visit(faces.points, faces.cells,
    [&](auto points, auto cells)
    {
      Summation<weighting, decltype(points), decltype(cells)>(
        faces, points, cells, sign, parallel, normals)
        .run();
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
