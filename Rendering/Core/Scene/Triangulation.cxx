// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulation.h"

#include "CellView.h"
#include "Chunks.h"
#include "Ears.h"
#include "Polygon.h"
#include "TouchingPolygon.h"

namespace lambent
{
namespace
{
constexpr std::size_t cellsPerChunk = 1024;

/// Cuts one cell after the other, reusing its memory.
class Cutter
{
public:
  Cutter(const CellSpan& cells, const TupleSpan& points)
    : Cells(cells)
    , Points(points)
  {
  }

  /// Whether a cell that was cut had a point that is wrong or not finite.
  bool hasBadPoint() const { return this->HasBadPoint; }

  std::size_t triangleCount(std::size_t cell) const
  {
    const std::size_t size = this->Cells.offsets[cell + 1] - this->Cells.offsets[cell];
    return size < 3 ? 0 : size - 2;
  }

  void cut(std::size_t cell, std::int32_t*& out)
  {
    const std::size_t count = this->triangleCount(cell);
    std::int32_t bad = -1;
    if (count == 0)
    {
      return;
    }
    if (!this->load(this->Cells.offsets[cell], count + 2, bad))
    {
      this->HasBadPoint = true;
      out = std::fill_n(out, 3 * count, bad);
    }
    else if (count == 1)
    {
      this->Shape.fan(out);
    }
    else
    {
      this->cutPolygon(this->Cells.offsets[cell], count + 2, out);
    }
  }

private:
  void cutPolygon(std::size_t begin, std::size_t size, std::int32_t*& out)
  {
    std::int32_t* const first = out;
    this->Shape.findNormal();
    const bool isConcave = this->Shape.isConcave();
    if (isConcave)
    {
      this->Clipper.cut(this->Shape, out);
    }
    // The two triangles of a convex quadrilateral lie at corners known to be convex.
    const double turned = isConcave || size > 4 ? this->Shape.turnedArea() : 0.0;
    const bool isWrong = !this->Shape.isRounding(turned, this->resolution());
    this->Shape.fan(out);
    if (isWrong)
    {
      this->mend(begin, size, turned, first);
    }
  }

  /// The resolution of the coordinates, relative to the largest one.
  double resolution() const { return this->Points.isDouble ? 0x1p-50 : 0x1p-22; }

  /// Cuts a polygon as one that touches itself, if it is one. The first attempt treats its
  /// coordinates as exact, the others as rounded to their digits.
  void mend(std::size_t begin, std::size_t size, double turned, std::int32_t* out)
  {
    std::int32_t bad;
    this->load(begin, size, bad);
    this->Shape.findNormal();
    const double largest = this->Shape.largestCoordinate();
    for (const double tolerance : { 0.0, 0x1p-50, this->resolution() })
    {
      if (cutTouchingPolygon(
            this->Shape.points, this->Shape.normal, tolerance * largest, this->Mended) &&
        this->mendedTurnedArea() < 0.5 * turned)
      {
        std::transform(this->Mended.begin(), this->Mended.end(), out,
          [this](std::size_t corner) { return this->Shape.ids[corner]; });
        return;
      }
    }
  }

  double mendedTurnedArea() const
  {
    double area = 0.0;
    for (std::size_t k = 0; k < this->Mended.size(); k += 3)
    {
      area += this->Shape.turnedArea(this->Mended[k], this->Mended[k + 1], this->Mended[k + 2]);
    }
    return area;
  }

  /// Returns false if a point does not exist (bad = -1) or is not finite.
  bool load(std::size_t begin, std::size_t size, std::int32_t& bad)
  {
    this->Shape.ids.resize(size);
    this->Shape.points.resize(size);
    bool isGood = true;
    for (std::size_t k = 0; k < size; ++k)
    {
      const std::uint64_t id = this->Cells.connectivity[begin + k];
      if (id >= this->Points.size)
      {
        bad = -1;
        return false;
      }
      this->Shape.ids[k] = static_cast<std::int32_t>(id);
      this->Shape.points[k] = this->Points[id];
      if (isGood && !isFinite(this->Shape.points[k]))
      {
        bad = this->Shape.ids[k];
        isGood = false;
      }
    }
    return isGood;
  }

  const CellSpan& Cells;
  const TupleSpan& Points;
  Polygon Shape;
  Ears Clipper;
  std::vector<std::size_t> Mended;
  bool HasBadPoint = false;
};

/// Calls body(worker, chunk) for all chunks of cells.
template <typename Body>
void forEachChunkOfCells(const Parallel& parallel, std::size_t count, Body&& body)
{
  forEachPart<cellsPerChunk>(parallel, count,
    [&](std::size_t begin, std::size_t end)
    { forEach(parallel, begin / cellsPerChunk, chunkCount(end, cellsPerChunk), body); });
}

/// Fills the list; false if no cell has a bad point.
bool cutAll(const CellSpan& cells, const TupleSpan& points, std::int64_t firstCell,
  const Parallel& parallel, TriangleList& list)
{
  const std::size_t count = cellCount(cells), chunks = chunkCount(count, cellsPerChunk);
  const auto endOf = [&](std::size_t chunk)
  { return std::min(count, (chunk + 1) * cellsPerChunk); };
  std::vector<Cutter> cutters(parallel.workers(), Cutter(cells, points));

  // 1. Find where the triangles of each chunk of cells begin.
  std::vector<std::size_t> first(chunks + 1, 0);
  forEachChunkOfCells(Share(parallel, 0.0, 0.1), count,
    [&](int worker, std::size_t chunk)
    {
      std::size_t triangles = 0;
      for (std::size_t cell = chunk * cellsPerChunk; cell < endOf(chunk); ++cell)
      {
        triangles += cutters[worker].triangleCount(cell);
      }
      first[chunk + 1] = triangles;
    });
  for (std::size_t chunk = 0; chunk < chunks; ++chunk)
  {
    first[chunk + 1] += first[chunk];
  }
  list.corners.resize(3 * first[chunks]);
  list.cells.resize(first[chunks]);

  // 2. Cut each chunk into its own place.
  forEachChunkOfCells(Share(parallel, 0.1, 1.0), count,
    [&](int worker, std::size_t chunk)
    {
      std::int32_t* out = list.corners.data() + 3 * first[chunk];
      auto cellOut = list.cells.begin() + static_cast<std::ptrdiff_t>(first[chunk]);
      for (std::size_t cell = chunk * cellsPerChunk; cell < endOf(chunk); ++cell)
      {
        cutters[worker].cut(cell, out);
        cellOut = std::fill_n(cellOut, cutters[worker].triangleCount(cell),
          firstCell + static_cast<std::int64_t>(cell));
      }
    });
  return std::any_of(
    cutters.begin(), cutters.end(), [](const Cutter& cutter) { return cutter.hasBadPoint(); });
}

/// Let all triangles of a strip with a bad point be of that point alone. Each is already, or
/// has good points only.
void spreadBadPoints(const TupleSpan& points, TriangleList& list)
{
  const std::size_t count = list.cells.size();
  for (std::size_t begin = 0, end = 0; begin < count; begin = end)
  {
    bool isBad = false;
    std::int32_t bad = 0;
    for (end = begin; end < count && list.cells[end] == list.cells[begin]; ++end)
    {
      const std::int32_t corner = list.corners[3 * end];
      if (corner < 0 || (!isBad && !isFinite(points[static_cast<std::size_t>(corner)])))
      {
        isBad = true;
        bad = corner;
      }
    }
    if (isBad)
    {
      std::fill(list.corners.begin() + static_cast<std::ptrdiff_t>(3 * begin),
        list.corners.begin() + static_cast<std::ptrdiff_t>(3 * end), bad);
    }
  }
}
}

TriangleList triangulate(const CellSpan& polygons, const TupleSpan& points, std::int64_t firstCell,
  const Parallel& parallel)
{
  TriangleList list;
  cutAll(polygons, points, firstCell, parallel, list);
  return list;
}

TriangleList triangulate(const MergedFaces& faces, const TupleSpan& points, std::int64_t firstCell,
  const Parallel& parallel)
{
  TriangleList list;
  const bool hasBadPoint = cutAll(faces.span(), points, 0, Share(parallel, 0.0, 0.9), list);
  forEachChunk<cellsPerChunk>(Share(parallel, 0.9, 1.0), list.cells.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t t = begin; t < end; ++t)
      {
        list.cells[t] = firstCell + faces.cells[list.cells[t]];
      }
    });
  if (hasBadPoint)
  {
    spreadBadPoints(points, list);
  }
  return list;
}
}
