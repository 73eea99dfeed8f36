// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointNormals.h"

#include "CellBlocks.h"

#include <algorithm>
#include <type_traits>

namespace lambent
{
namespace
{
// More than one range per worker evens out the work; each further one repeats the
// faces at its ends.
constexpr std::size_t RangesPerWorker = 4;

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

  template <typename Id>
  void add(Id point, const Vec3& contribution) const
  {
    if (this->contains(point))
    {
      Vec3& sum = this->sums[static_cast<std::size_t>(point - this->begin)];
      sum = sum + contribution;
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
      [&](int i, const Vec3& contribution) { range.add(corners[i], contribution); });
  }
  else
  {
    contributePolygon<weighting>(points, corners, size, scratch,
      [&](Id point, const Vec3& contribution) { range.add(point, contribution); });
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
  const std::size_t workers = static_cast<std::size_t>(parallel.workers());
  const std::size_t ranges = workers > 1 ? RangesPerWorker * workers : 1;
  std::vector<std::vector<Vec3>> sums(workers);

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
