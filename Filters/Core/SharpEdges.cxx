// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SharpEdges.h"

#include "DisjointSets.h"
#include "Elementary.h"

#include <algorithm>
#include <memory>
#include <numeric>

namespace lambent
{
namespace
{
constexpr std::size_t PointsPerChunk = 2048;

/// Allocates a large array without initializing it. A vector would write it all twice, the first
/// time without checkpoints.
template <typename Item>
std::unique_ptr<Item[]> makeUnwritten(std::size_t count)
{
  return std::unique_ptr<Item[]>(new Item[count]);
}

struct Corner
{
  std::int64_t face;
  std::int64_t place; ///< in the connectivity
};

/// The corners of point p are corners[begin[p]] to corners[begin[p + 1] - 1].
struct CornersOfPoints
{
  std::vector<std::int64_t> begin;
  std::unique_ptr<Corner[]> corners;
  std::size_t cornerCount = 0;
};

CornersOfPoints listCorners(const Faces& faces, const Parallel& parallel)
{
  CornersOfPoints result;
  result.begin.assign(faces.points.size + 1, 0);
  visit(faces.cells,
    [&](auto cells)
    {
      const auto first = cells.offsets[0];
      const auto count = cells.offsets[cellCount(faces.cells)];
      result.cornerCount = static_cast<std::size_t>(count);
      result.corners = makeUnwritten<Corner>(result.cornerCount);
      forEachPart(Share(parallel, 0.0, 0.3), static_cast<std::size_t>(count - first),
        [&](std::size_t begin, std::size_t end)
        {
          std::for_each(cells.corners + first + begin, cells.corners + first + end,
            [&](auto point) { ++result.begin[point + 1]; });
        });
      std::partial_sum(result.begin.begin(), result.begin.end(), result.begin.begin());
      std::vector<std::int64_t> next(result.begin.begin(), result.begin.end() - 1);
      forEachPart(Share(parallel, 0.3, 1.0), cellCount(faces.cells),
        [&](std::size_t begin, std::size_t end)
        {
          for (std::size_t face = begin; face < end; ++face)
          {
            for (auto i = cells.offsets[face]; i < cells.offsets[face + 1]; ++i)
            {
              result.corners[next[cells.corners[i]]++] = { static_cast<std::int64_t>(face), i };
            }
          }
        });
    });
  return result;
}

/// An edge from the current point to another one, as a side of a face.
struct Side
{
  std::int64_t otherPoint;
  int corner; ///< the index among the point's corners

  bool operator<(const Side& other) const
  {
    return this->otherPoint != other.otherPoint ? this->otherPoint < other.otherPoint
                                                : this->corner < other.corner;
  }
};

/// Groups the faces around a point. Reuses its memory from point to point.
class Grouping
{
public:
  Grouping(const Vec3* faceNormals, double featureAngle)
    : FaceNormals(faceNormals)
    , Cosine(cosDegrees(featureAngle))
    , NothingIsSharp(featureAngle >= 180.0)
  {
  }

  /// Finds the group of each corner at a point. Returns the number of groups.
  template <typename Cells>
  int findGroups(const Cells& cells, std::int64_t point, const Corner* corners, int count)
  {
    this->Groups.reset(count);
    this->listSides(cells, point, corners, count);
    for (auto side = this->Sides.begin(); side != this->Sides.end();)
    {
      const auto end = std::find_if(side, this->Sides.end(),
        [&](const Side& other) { return other.otherPoint != side->otherPoint; });
      if (end - side == 2 &&
        this->isSmooth(corners[side[0].corner].face, corners[side[1].corner].face))
      {
        this->Groups.join(side[0].corner, side[1].corner);
      }
      side = end;
    }
    return this->Groups.number();
  }

  int group(int corner) const { return this->Groups.set(corner); }

private:
  template <typename Cells>
  void listSides(const Cells& cells, std::int64_t point, const Corner* corners, int count)
  {
    this->Sides.clear();
    for (int i = 0; i < count; ++i)
    {
      if (i > 0 && corners[i].face == corners[i - 1].face)
      {
        this->Groups.join(i, i - 1); // a face that uses the point twice is still one face
      }
      const auto begin = cells.offsets[corners[i].face];
      const auto end = cells.offsets[corners[i].face + 1];
      const auto place = corners[i].place;
      const std::int64_t next = cells.corners[place + 1 < end ? place + 1 : begin];
      const std::int64_t previous = cells.corners[place > begin ? place - 1 : end - 1];
      for (const std::int64_t other : { next, previous })
      {
        if (other != point)
        {
          this->Sides.push_back({ other, i });
        }
      }
    }
    std::sort(this->Sides.begin(), this->Sides.end());
  }

  bool isSmooth(std::int64_t faceA, std::int64_t faceB) const
  {
    const Vec3& a = this->FaceNormals[faceA];
    const Vec3& b = this->FaceNormals[faceB];
    if (a == Vec3(0.0) || b == Vec3(0.0))
    {
      return false;
    }
    return this->NothingIsSharp || dot(a, b) >= this->Cosine;
  }

  const Vec3* const FaceNormals;
  const double Cosine;
  const bool NothingIsSharp;
  std::vector<Side> Sides;
  DisjointSets Groups;
};

/// Returns the group of each listed corner. Sets copyCount[p + 1] to the number of copies that p
/// needs.
std::unique_ptr<int[]> groupCorners(const Faces& faces, const CornersOfPoints& points,
  double featureAngle, const Parallel& parallel, std::vector<std::int64_t>& copyCount)
{
  const auto normals = makeUnwritten<Vec3>(cellCount(faces.cells));
  visitFaceNormals(faces, Share(parallel, 0.0, 0.2),
    [&](std::size_t face, const Vec3& normal) { normals[face] = normal; });

  auto groups = makeUnwritten<int>(points.cornerCount);
  visit(faces.cells,
    [&](auto cells)
    {
      forEachChunk<PointsPerChunk>(Share(parallel, 0.2, 1.0), faces.points.size,
        [&](std::size_t begin, std::size_t end)
        {
          Grouping grouping(normals.get(), featureAngle);
          for (std::size_t point = begin; point < end; ++point)
          {
            const std::int64_t first = points.begin[point];
            const int count = static_cast<int>(points.begin[point + 1] - first);
            const int found = grouping.findGroups(
              cells, static_cast<std::int64_t>(point), points.corners.get() + first, count);
            copyCount[point + 1] = std::max(found - 1, 0);
            for (int i = 0; i < count; ++i)
            {
              groups[first + i] = grouping.group(i);
            }
          }
        });
    });
  return groups;
}
}

SplitMesh splitSharpEdges(const Faces& faces, double featureAngle, const Parallel& parallel)
{
  SplitMesh result;
  if (cellCount(faces.cells) == 0)
  {
    return result;
  }
  const std::size_t pointCount = faces.points.size;
  const CornersOfPoints points = listCorners(faces, Share(parallel, 0.0, 0.4));
  std::vector<std::int64_t> firstCopy(pointCount + 1, 0);
  const auto groups =
    groupCorners(faces, points, featureAngle, Share(parallel, 0.4, 0.8), firstCopy);
  std::partial_sum(firstCopy.begin(), firstCopy.end(), firstCopy.begin());

  result.connectivity.resize(points.cornerCount);
  result.copiedPoints.resize(static_cast<std::size_t>(firstCopy.back()));
  forEachChunk<PointsPerChunk>(Share(parallel, 0.8, 1.0), pointCount,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t point = begin; point < end; ++point)
      {
        std::fill(result.copiedPoints.begin() + firstCopy[point],
          result.copiedPoints.begin() + firstCopy[point + 1], static_cast<std::int64_t>(point));
        for (std::int64_t i = points.begin[point]; i < points.begin[point + 1]; ++i)
        {
          result.connectivity[points.corners[i].place] = static_cast<std::int64_t>(
            groups[i] == 0 ? point : pointCount + firstCopy[point] + groups[i] - 1);
        }
      }
    });
  return result;
}
}
