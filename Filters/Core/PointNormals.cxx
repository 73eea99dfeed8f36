// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PointNormals.h"

#include "BlockSums.h"
#include "RangeWalks.h"
#include "VectorTarget.h"

#include <type_traits>

namespace lambent
{
namespace
{
/// Steps 2 and 3 of the header for a range of points.
template <Weighting weighting, typename Points, typename Cells>
class Summation
{
public:
  Summation(
    const Faces& faces, const Points& points, const Cells& cells, float sign, float* normals)
    : AllFaces(faces)
    , AllPoints(points)
    , AllCells(cells)
    , Sign(sign)
    , Normals(normals)
  {
  }

  void reset(const PointRange& range) { this->Sums.reset(range.begin, range.end); }
  int passCount() const { return 2; }
  std::size_t stepCount(int pass) const { return pass == 0 ? this->AllFaces.blocks.size() : 1; }

  std::size_t step(int pass, std::size_t i)
  {
    if (pass == 1)
    {
      writeNormals(
        this->Sums, this->Sign, this->UseKernels, this->Normals + 3 * this->Sums.begin());
      return 0;
    }
    const CellBlock& block = this->AllFaces.blocks[i];
    if (!block.touches(this->Sums.begin(), this->Sums.end()))
    {
      return 0;
    }
    addBlock<weighting>(
      this->AllFaces, this->AllPoints, this->AllCells, block, this->UseKernels, this->Sums);
    return block.end - block.begin;
  }

private:
  const Faces& AllFaces;
  const Points& AllPoints;
  const Cells& AllCells;
  const float Sign;
  float* const Normals;
  const bool UseKernels = areVectorsInUse();
  PointSums Sums;
};

template <Weighting weighting>
void sumUp(const Faces& faces, float sign, const Parallel& parallel, float* normals)
{
  visit(faces.points, faces.cells,
    [&](auto points, auto cells)
    {
      const Summation<weighting, decltype(points), decltype(cells)> task(
        faces, points, cells, sign, normals);
      const PointRanges ranges(faces.blocks, faces.points.size, parallel.workers());
      RangeWalks<std::decay_t<decltype(task)>>(ranges, task, parallel).run();
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
