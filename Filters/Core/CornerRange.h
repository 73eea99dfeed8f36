// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the normals of the corners at a range of points
 *
 * The passes of CornerNormals.h: sums and normals of the points, creases, the corners at
 * creased points, and the normals of these corners (CreasedPoint.h).
 */
#ifndef lambent_CornerRange_h
#define lambent_CornerRange_h

#include "BlockSums.h"
#include "CreasedPoint.h"
#include "Creases.h"
#include "RangeWalks.h"
#include "VectorTarget.h"

#include <algorithm>
#include <atomic>
#include <vector>

namespace lambent
{
/// cos(angle / 2), but at least 2^-20. With a cosine of zero, at 180 degrees, a point's normal
/// could be mere rounding error although no face is steep.
inline double cosineOfHalf(double angle)
{
  return std::max(cosDegrees(0.5 * angle), 1.0 / (1 << 20));
}

/// The normals that a range of points needs beyond one per point.
struct FurtherNormals
{
  struct Use
  {
    std::int64_t place;  ///< in the connectivity
    std::int32_t number; ///< of the normal, counted from the first in this range
  };

  std::vector<float> normals;
  std::vector<Use> uses;
};

/// Computes the corner normals of a range of points: a task for RangeWalks.
template <typename Points, typename Cells>
class CornerRange
{
public:
  CornerRange(const Faces& faces, const Points& points, const Cells& cells, double largestAngle,
    float* normals, std::vector<FurtherNormals>& results, std::atomic<std::size_t>& resultCount)
    : AllFaces(faces)
    , AllPoints(points)
    , AllCells(cells)
    , Normals(normals)
    , Results(results)
    , ResultCount(resultCount)
    , Range(cosineOfHalf(largestAngle))
    , Solver(points, cells, largestAngle)
  {
  }

  void reset(const PointRange& range)
  {
    this->Sums.reset(range.begin, range.end);
    this->Range.reset(range.begin, range.end);
    this->Result = &this->Results[range.index];
    this->Creased.clear();
    this->Found.clear();
    this->FacesWithArea.clear();
  }

  int passCount() const { return PassCount; }

  std::size_t stepCount(int pass) const
  {
    switch (pass)
    {
      case Sum:
      case Mark:
        return this->AllFaces.blocks.size();
      case Collect:
        return this->Creased.empty() ? 0 : this->AllFaces.blocks.size();
      case Solve:
        return chunkCount(this->Creased.size(), pointsPerStep);
      default:
        return 1;
    }
  }

  std::size_t step(int pass, std::size_t i)
  {
    switch (pass)
    {
      case Write:
        writeNormals(this->Sums, 1.0f, this->UseKernels, this->Range.normals.data());
        return this->Sums.size();
      case Number:
        return this->numberCreased();
      case Sort:
        return this->sortCorners();
      case Solve:
        return this->solve(i);
      case Keep:
        std::copy_n(this->Range.normals.data(), 3 * this->Range.size(),
          this->Normals + 3 * this->Sums.begin());
        return this->Range.size();
      default:
        return this->visitBlock(pass, this->AllFaces.blocks[i]);
    }
  }

private:
  enum Pass
  {
    Sum,     ///< add up the contributions of the faces at each point
    Write,   ///< write the points' normals
    Mark,    ///< mark the creased points
    Number,  ///< number them
    Collect, ///< collect the corners at them
    Sort,    ///< sort these corners by point
    Solve,   ///< compute the normals at creased points
    Keep,    ///< copy the final point normals to the output
    PassCount
  };
  static constexpr std::size_t pointsPerStep = 256;

  /// A corner, and the number of its creased point.
  struct FoundCorner
  {
    std::int32_t creased;
    Corner corner;
  };

  std::size_t visitBlock(int pass, const CellBlock& block)
  {
    if (!block.touches(this->Sums.begin(), this->Sums.end()))
    {
      return 0;
    }
    if (pass == Sum)
    {
      addBlock<Weighting::Angle>(
        this->AllFaces, this->AllPoints, this->AllCells, block, this->UseKernels, this->Sums);
    }
    else if (pass == Mark)
    {
      this->markBlock(block);
    }
    else
    {
      this->collect(block);
    }
    return block.end - block.begin;
  }

  void markBlock(const CellBlock& block)
  {
    if (this->UseKernels && block.hasOnlyTriangles && this->AllFaces.skip.empty())
    {
      markCreases(this->AllFaces.points, this->AllCells.cell(block.begin), block.end - block.begin,
        this->Range);
      return;
    }
    for (std::size_t face = block.begin; face < block.end; ++face)
    {
      const auto* const ids = this->AllCells.cell(face);
      const std::size_t size = this->AllCells.cellSize(face);
      const bool isHere = std::any_of(
        ids, ids + size, [this](auto id) { return this->Range.place(id) < this->Range.size(); });
      if (!isHere || this->AllFaces.isSkipped(face))
      {
        continue;
      }
      const Vec3 area = areaVector(this->AllPoints, ids, size);
      for (std::size_t k = 0; k < size; ++k)
      {
        const std::size_t place = this->Range.place(ids[k]);
        this->Range.marks[place] |=
          isSteep(area, this->Range.normal(place), this->Range.squaredCosine);
      }
    }
  }

  std::size_t numberCreased()
  {
    this->Range.marks.back() = 0; // from here on only points in the range are marked
    this->NumberOf.resize(this->Range.size());
    for (std::size_t place = 0; place < this->Range.size(); ++place)
    {
      if (this->Range.marks[place])
      {
        this->NumberOf[place] = static_cast<std::int32_t>(this->Creased.size());
        this->Creased.push_back(this->Sums.begin() + static_cast<std::int64_t>(place));
      }
    }
    return this->Range.size();
  }

  void collect(const CellBlock& block)
  {
    if (block.hasOnlyTriangles)
    {
      this->collectFromTriangles(block);
      return;
    }
    for (std::size_t face = block.begin; face < block.end; ++face)
    {
      this->collectFrom(face);
    }
  }

  void collectFromTriangles(const CellBlock& block)
  {
    const auto* ids = this->AllCells.cell(block.begin);
    for (std::size_t face = block.begin; face < block.end; ++face, ids += 3)
    {
      if (this->mark(ids[0]) | this->mark(ids[1]) | this->mark(ids[2]))
      {
        this->collectFrom(face);
      }
    }
  }

  /// Nonzero if the point is in the range and creased.
  template <typename Id>
  unsigned char mark(Id point) const
  {
    return this->Range.marks[this->Range.place(point)];
  }

  void collectFrom(std::size_t face)
  {
    const std::int64_t begin = this->AllCells.offsets[face];
    const std::int64_t end = this->AllCells.offsets[face + 1];
    bool isUsed = false;
    for (std::int64_t place = begin; place < end; ++place)
    {
      const auto point = this->AllCells.corners[place];
      if (!this->mark(point))
      {
        continue;
      }
      if (!isUsed && !this->takeFace(face))
      {
        return;
      }
      isUsed = true;
      this->Found.push_back({ this->NumberOf[this->Range.place(point)],
        { place, static_cast<std::int64_t>(this->FacesWithArea.size()) - 1 } });
    }
  }

  /// Adds the face to FacesWithArea. Returns false if it has no area or is skipped.
  bool takeFace(std::size_t face)
  {
    constexpr std::size_t manyCorners = 16;
    const auto* const ids = this->AllCells.cell(face);
    const std::size_t size = this->AllCells.cellSize(face);
    const Vec3 area = areaVector(this->AllPoints, ids, size);
    if (this->AllFaces.isSkipped(face) || !isUsableSquare(dot(area, area)))
    {
      return false;
    }
    std::size_t changes = 0;
    for (std::size_t k = 0; size > manyCorners && k < size; ++k)
    {
      changes += ids[k] != ids[k + 1 == size ? 0 : k + 1];
    }
    this->FacesWithArea.push_back({ static_cast<std::int64_t>(face), area, changes > 3 });
    return true;
  }

  /// A counting sort, so that the corners of a point keep their order.
  std::size_t sortCorners()
  {
    this->First.assign(this->Creased.size() + 1, 0);
    for (const FoundCorner& found : this->Found)
    {
      ++this->First[static_cast<std::size_t>(found.creased) + 1];
    }
    for (std::size_t k = 0; k < this->Creased.size(); ++k)
    {
      this->First[k + 1] += this->First[k];
    }
    this->Corners.resize(this->Found.size());
    for (const FoundCorner& found : this->Found)
    {
      this->Corners[this->First[found.creased]++] = found.corner;
    }
    // Each entry has advanced to the beginning of the next.
    std::copy_backward(this->First.begin(), this->First.end() - 1, this->First.end());
    this->First.front() = 0;
    return this->Found.size();
  }

  std::size_t solve(std::size_t step)
  {
    const std::size_t begin = step * pointsPerStep;
    const std::size_t end = std::min(this->Creased.size(), begin + pointsPerStep);
    const std::size_t before = this->Result->normals.size();
    for (std::size_t k = begin; k < end; ++k)
    {
      const Corner* const corners = this->Corners.data() + this->First[k];
      const int count = static_cast<int>(this->First[k + 1] - this->First[k]);
      const std::int64_t point = this->Creased[k];
      const PointSum& sum = this->Sums.data()[this->Sums.place(point)];
      if (this->Solver.solve(
            point, { sum.x, sum.y, sum.z }, this->FacesWithArea.data(), corners, count))
      {
        this->store(point, corners, count);
      }
    }
    this->ResultCount += (this->Result->normals.size() - before) / 3;
    return 4 * (this->First[end] - this->First[begin]); // each takes as long as several faces
  }

  /// The first normal becomes that of the point.
  void store(std::int64_t point, const Corner* corners, int count)
  {
    constexpr std::int32_t none = -1;
    this->NumberOfKey.assign(static_cast<std::size_t>(count), none);
    for (int i = 0; i < count; ++i)
    {
      const int key = this->Solver.key(i);
      if (i == 0)
      {
        writeNormal(
          this->Solver.normal(i), 1.0f, &this->Range.normals[3 * this->Range.place(point)]);
      }
      if (key == this->Solver.key(0))
      {
        continue;
      }
      std::int32_t& number = this->NumberOfKey[key];
      if (number == none)
      {
        std::vector<float>& normals = this->Result->normals;
        number = static_cast<std::int32_t>(normals.size() / 3);
        normals.resize(normals.size() + 3);
        writeNormal(this->Solver.normal(i), 1.0f, &normals[normals.size() - 3]);
      }
      this->Result->uses.push_back({ corners[i].place, number });
    }
  }

  const Faces& AllFaces;
  const Points& AllPoints;
  const Cells& AllCells;
  float* const Normals;
  std::vector<FurtherNormals>& Results;
  std::atomic<std::size_t>& ResultCount; ///< the normals of all ranges so far
  const bool UseKernels = areVectorsInUse();

  PointSums Sums;
  Creases Range;
  FurtherNormals* Result = nullptr;
  std::vector<std::int64_t> Creased;
  std::vector<std::int32_t> NumberOf; ///< for each point of the range that is creased
  std::vector<FoundCorner> Found;
  std::vector<FaceWithArea> FacesWithArea;
  std::vector<std::size_t> First; ///< the first corner of each creased point
  std::vector<Corner> Corners;
  CreasedPoint<Points, Cells> Solver;
  std::vector<std::int32_t> NumberOfKey;
};
}

#endif
