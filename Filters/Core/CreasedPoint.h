// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the corner normals at one creased point
 *
 * Steps 2 to 4 of CornerNormals.h. An object processes one point after another and reuses its
 * memory.
 */
#ifndef lambent_CreasedPoint_h
#define lambent_CreasedPoint_h

#include "DisjointSets.h"
#include "Elementary.h"
#include "NormalContribution.h"
#include "OppositePolygons.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace lambent
{
/// A face that has an area.
struct FaceWithArea
{
  std::int64_t face;
  Vec3 area;    ///< areaVector()
  bool isLarge; ///< it has many corners, and more than 3 without consecutive repeats
};

/// One occurrence of a point in a face.
struct Corner
{
  std::int64_t place; ///< in the connectivity
  std::int64_t face;  ///< the face's index in the array of faces with an area
};

template <typename Points, typename Cells>
class CreasedPoint
{
public:
  CreasedPoint(const Points& points, const Cells& cells, double largestAngle)
    : AllPoints(points)
    , AllCells(cells)
    , Opposites(cells)
    , Cosine(cosDegrees(largestAngle))
    , AnyAngleIsSmooth(largestAngle >= 180.0)
  {
  }

  /**
   * Computes the normals of the corners at a point. `corners` lists those of faces with an area
   * in ascending order; `allSum` is the sum of these faces' contributions. Returns false if it
   * gives the normal of all corners.
   */
  template <typename Id>
  bool solve(
    Id point, const Vec3& allSum, const FaceWithArea* faces, const Corner* corners, int count)
  {
    this->Faces = faces;
    this->Corners = corners;
    this->findFaceNormals(count);
    this->Groups.reset(count);
    this->listSides(point, count);
    this->linkFaces();
    const int groups = this->Groups.number();
    if (groups == 1 && this->isLong(allSum, count))
    {
      return false;
    }
    this->sumUp(point, count, groups);
    return true;
  }

  /// The normal at a corner of the last point, not normalized.
  const Vec3& normal(int corner) const
  {
    const Sum& sum = this->Sums[this->Groups.set(corner)];
    return sum.isDirection ? sum.vector : this->FaceNormals[corner];
  }

  /// Corners with the same key have the same normal; keys are below the number of corners.
  int key(int corner) const
  {
    const Sum& sum = this->Sums[this->Groups.set(corner)];
    return sum.isDirection ? sum.firstCorner : this->FirstOfFace[corner];
  }

private:
  static constexpr std::ptrdiff_t mostSidesAtEdge = 64;

  /// An edge between the point and another one, as a side of a face. The face runs from the
  /// point to the other one (`leaves`), or from there to the point.
  struct Side
  {
    std::int64_t other;
    int corner;
    bool leaves;

    bool operator<(const Side& side) const
    {
      return this->other != side.other ? this->other < side.other : this->corner < side.corner;
    }
  };

  struct Sum
  {
    Vec3 vector{ 0.0 };
    double length = 0.0; ///< the sum of the terms' lengths
    int firstCorner = -1;
    bool isDirection = false;
  };

  void findFaceNormals(int count)
  {
    this->FaceNormals.resize(static_cast<std::size_t>(count));
    this->FirstOfFace.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
    {
      const bool isSameFace = i > 0 && this->Corners[i - 1].face == this->Corners[i].face;
      const Vec3& area = this->Faces[this->Corners[i].face].area;
      this->FaceNormals[i] =
        isSameFace ? this->FaceNormals[i - 1] : area * (1.0 / std::sqrt(dot(area, area)));
      this->FirstOfFace[i] = isSameFace ? this->FirstOfFace[i - 1] : i;
    }
  }

  std::int64_t face(int corner) const { return this->Faces[this->Corners[corner].face].face; }

  template <typename Id>
  void listSides(Id point, int count)
  {
    this->Sides.clear();
    for (int i = 0; i < count; ++i)
    {
      if (this->FirstOfFace[i] != i)
      {
        this->Groups.join(i, i - 1); // a face that uses the point twice is still one face
      }
      const auto begin = this->AllCells.offsets[this->face(i)];
      const auto end = this->AllCells.offsets[this->face(i) + 1];
      const auto place = this->Corners[i].place;
      const auto next = this->AllCells.corners[place + 1 < end ? place + 1 : begin];
      const auto previous = this->AllCells.corners[place > begin ? place - 1 : end - 1];
      if (next != point)
      {
        this->Sides.push_back({ next, i, true });
      }
      if (previous != point)
      {
        this->Sides.push_back({ previous, i, false });
      }
    }
    std::sort(this->Sides.begin(), this->Sides.end());
  }

  void linkFaces()
  {
    for (auto side = this->Sides.begin(); side != this->Sides.end();)
    {
      const auto end = std::find_if(
        side, this->Sides.end(), [&](const Side& other) { return other.other != side->other; });
      for (auto a = side; end - side <= mostSidesAtEdge && a != end; ++a)
      {
        for (auto b = a + 1; b != end; ++b)
        {
          if (a->leaves != b->leaves && this->areLinked(a->corner, b->corner))
          {
            this->Groups.join(a->corner, b->corner);
          }
        }
      }
      side = end;
    }
  }

  bool areLinked(int a, int b)
  {
    const bool isSmooth =
      this->AnyAngleIsSmooth || dot(this->FaceNormals[a], this->FaceNormals[b]) >= this->Cosine;
    return isSmooth && !this->Opposites.areOpposite(this->face(a), this->face(b));
  }

  static constexpr double leastPart = 1.0 / (1 << 20);

  /// Whether a sum of `count` terms has a direction, whatever their lengths. These are angles, less
  /// than mostOfTerm.
  static bool isLong(const Vec3& sum, int count)
  {
    constexpr double mostOfTerm = 7.0; // more than a full turn
    const double least = leastPart * (mostOfTerm * count);
    const double square = dot(sum, sum);
    return isUsableSquare(square) && square >= least * least;
  }

  /// Calls add(term) for the contributions of a face at the point. `corner` is the face's first
  /// corner there.
  template <typename Id, typename Add>
  void contribute(Id point, int corner, int count, Add&& add)
  {
    const std::int64_t face = this->face(corner);
    const auto* const ids = this->AllCells.cell(face);
    const std::size_t size = this->AllCells.cellSize(face);
    const auto addHere = [&](auto id, const Vec3& term)
    {
      if (id == point)
      {
        add(term);
      }
    };
    if (size == 3)
    {
      contributeTriangle<Weighting::Angle>(this->AllPoints[ids[0]], this->AllPoints[ids[1]],
        this->AllPoints[ids[2]], [&](int i, const Vec3& term) { addHere(ids[i], term); });
    }
    else if (!this->Faces[this->Corners[corner].face].isLarge)
    {
      contributePolygon<Weighting::Angle>(this->AllPoints, ids, size, this->Scratch, addHere);
    }
    else
    {
      this->contributeLargePolygon(point, corner, count, add);
    }
  }

  /// contributePolygon() at one point only. A polygon of n corners can be creased at n points;
  /// traversing it for each of them would take quadratic time.
  template <typename Id, typename Add>
  void contributeLargePolygon(Id point, int corner, int count, Add&& add)
  {
    const std::int64_t face = this->face(corner);
    const auto* const ids = this->AllCells.cell(face);
    const auto size = static_cast<std::int64_t>(this->AllCells.cellSize(face));
    const Vec3 p = this->AllPoints[point];
    for (int i = corner; i < count && this->FirstOfFace[i] == corner; ++i)
    {
      const std::int64_t place = this->Corners[i].place - this->AllCells.offsets[face];
      if (place > 0 && ids[place - 1] == point)
      {
        continue; // consecutive repeats count once
      }
      std::int64_t next = place, previous = place;
      while (next < size && ids[next] == point)
      {
        ++next;
      }
      next = next == size ? 0 : next; // may be the point itself: zero length adds nothing
      do
      {
        previous = previous == 0 ? size - 1 : previous - 1;
      } while (ids[previous] == point);
      add(cornerContribution<Weighting::Angle>(this->Faces[this->Corners[i].face].area,
        this->AllPoints[ids[next]] - p, this->AllPoints[ids[previous]] - p));
    }
  }

  template <typename Id>
  void sumUp(Id point, int count, int groups)
  {
    this->Sums.assign(static_cast<std::size_t>(groups), Sum());
    for (int i = 0; i < count; ++i)
    {
      if (this->FirstOfFace[i] != i)
      {
        continue;
      }
      Sum& sum = this->Sums[this->Groups.set(i)];
      sum.firstCorner = sum.firstCorner < 0 ? i : sum.firstCorner;
      this->contribute(point, i, count,
        [&](const Vec3& term)
        {
          sum.vector = sum.vector + term;
          sum.length += length(term);
        });
    }
    for (Sum& sum : this->Sums)
    {
      const double square = dot(sum.vector, sum.vector);
      const double least = leastPart * sum.length;
      sum.isDirection = isUsableSquare(square) && square >= least * least;
    }
  }

  const Points& AllPoints;
  const Cells& AllCells;
  OppositePolygons<Cells> Opposites;
  const double Cosine;
  const bool AnyAngleIsSmooth;
  const FaceWithArea* Faces = nullptr;
  const Corner* Corners = nullptr;
  std::vector<Vec3> FaceNormals; ///< of each corner's face
  std::vector<int> FirstOfFace;  ///< the first corner of each corner's face
  std::vector<Side> Sides;
  DisjointSets Groups;
  std::vector<Sum> Sums;
  std::vector<std::decay_t<decltype(*std::declval<Cells>().corners)>> Scratch;
};
}

#endif
