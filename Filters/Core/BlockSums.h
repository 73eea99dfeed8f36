// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief add faces to the sums of a range of points, and convert the sums to normals
 */
#ifndef lambent_BlockSums_h
#define lambent_BlockSums_h

#include "NormalKernel.h"
#include "PointNormals.h"
#include "PointSums.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

namespace lambent
{
template <Weighting weighting, typename Points, typename Id>
inline void addFace(const Points& points, const Id* corners, std::size_t size,
  std::vector<Id>& scratch, PointSums& sums)
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
inline void addBlock(const Faces& faces, const Points& points, const Cells& cells,
  const CellBlock& block, bool useKernels, PointSums& sums)
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

/// Writes the sum, scaled to unit length times sign, as three floats; zeros if its squared length
/// is not usable.
inline void writeNormal(const Vec3& sum, float sign, float* normal)
{
  const double square = dot(sum, sum);
  const bool isUsable = isUsableSquare(square);
  const Vec3 unit = isUsable ? sum * (1.0 / std::sqrt(square)) : Vec3(0.0);
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = isUsable ? sign * static_cast<float>(unit[i]) : 0.0f; // no -0 for a missing normal
  }
}

/// Writes the normals of the points of a range.
inline void writeNormals(const PointSums& sums, float sign, bool useKernels, float* normals)
{
  std::size_t i = useKernels ? writeNormals(sums.data(), sums.size(), sign, normals) : 0;
  for (; i < sums.size(); ++i)
  {
    const PointSum& sum = sums.data()[i];
    writeNormal({ sum.x, sum.y, sum.z }, sign, normals + 3 * i);
  }
}

}

#endif
