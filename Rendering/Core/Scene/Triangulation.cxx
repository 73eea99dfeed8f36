// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulation.h"

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
  Cutter(const CellSpan& cells, CellKind kind, const TupleSpan& points)
    : Cells(cells)
    , Kind(kind)
    , Points(points)
  {
  }

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
      for (std::size_t k = 0; k < count; ++k)
      {
        putTriangle(out, bad, bad, bad);
      }
    }
    else if (this->Kind == CellKind::Strips)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        const std::int32_t* p = &this->Shape.ids[k];
        putTriangle(out, p[k % 2], p[1 - k % 2], p[2]);
      }
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
  CellKind Kind;
  const TupleSpan& Points;
  Polygon Shape;
  Ears Clipper;
  std::vector<std::size_t> Mended;
};
}

void triangulate(const CellSpan& cells, CellKind kind, const TupleSpan& points,
  std::int64_t firstCell, const Parallel& parallel, TriangleList& list)
{
  const std::size_t count = cells.offsets.size > 0 ? cells.offsets.size - 1 : 0;
  const std::size_t chunks = (count + cellsPerChunk - 1) / cellsPerChunk;
  if (count == 0)
  {
    return;
  }
  const auto endOf = [&](std::size_t chunk)
  { return std::min(count, (chunk + 1) * cellsPerChunk); };
  std::vector<Cutter> cutters(parallel.workers(), Cutter(cells, kind, points));

  // 1. Find where the triangles of each chunk of cells begin.
  std::vector<std::size_t> first(chunks + 1, list.cells.size());
  forEach(parallel, 0, chunks,
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
  forEach(parallel, 0, chunks,
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
}
}
