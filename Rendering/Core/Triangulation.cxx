// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Triangulation.h"

namespace lambent
{
namespace
{
constexpr std::size_t cellsPerChunk = 1024;

/// Corners of one cell are written from here on.
using Out = std::int32_t*;

void put(Out& out, std::int32_t a, std::int32_t b, std::int32_t c)
{
  *out++ = a;
  *out++ = b;
  *out++ = c;
}

/// Twice the signed area that the corner a b c has, seen against the normal.
double turn(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal)
{
  return dot(cross(b - a, c - b), normal);
}

/// What is left of a polygon while its ears are cut off.
struct Polygon
{
  std::vector<std::int32_t> ids;
  std::vector<Vec3> points;
  Vec3 normal{ 0.0 };

  std::size_t size() const { return this->ids.size(); }
  std::size_t next(std::size_t k) const { return k + 1 == this->size() ? 0 : k + 1; }
  std::size_t previous(std::size_t k) const { return k == 0 ? this->size() - 1 : k - 1; }

  void findNormal()
  {
    this->normal = Vec3(0.0);
    for (std::size_t k = 0; k < this->size(); ++k)
    {
      this->normal = this->normal +
        cross(this->points[k] - this->points[0], this->points[this->next(k)] - this->points[0]);
    }
  }

  double turnAt(std::size_t k) const
  {
    return turn(
      this->points[this->previous(k)], this->points[k], this->points[this->next(k)], this->normal);
  }

  bool isConvex() const
  {
    for (std::size_t k = 0; k < this->size(); ++k)
    {
      if (this->turnAt(k) < 0.0)
      {
        return false;
      }
    }
    return true;
  }

  bool isEar(std::size_t k) const
  {
    if (!(this->turnAt(k) > 0.0))
    {
      return false;
    }
    const Vec3& a = this->points[this->previous(k)];
    const Vec3& b = this->points[k];
    const Vec3& c = this->points[this->next(k)];
    for (std::size_t other = this->next(this->next(k)); other != this->previous(k);
         other = this->next(other))
    {
      const Vec3& p = this->points[other];
      if (p != a && p != b && p != c && turn(a, b, p, this->normal) >= 0.0 &&
        turn(b, c, p, this->normal) >= 0.0 && turn(c, a, p, this->normal) >= 0.0)
      {
        return false;
      }
    }
    return true;
  }

  void cutEars(Out& out)
  {
    std::size_t k = 0;
    for (std::size_t tried = 0; this->size() > 3 && tried < this->size(); ++tried)
    {
      if (!this->isEar(k))
      {
        k = this->next(k);
        continue;
      }
      put(out, this->ids[this->previous(k)], this->ids[k], this->ids[this->next(k)]);
      this->ids.erase(this->ids.begin() + static_cast<std::ptrdiff_t>(k));
      this->points.erase(this->points.begin() + static_cast<std::ptrdiff_t>(k));
      k = 0;
      tried = 0;
    }
    this->fan(out);
  }

  void fan(Out& out) const
  {
    for (std::size_t k = 2; k < this->size(); ++k)
    {
      put(out, this->ids[0], this->ids[k - 1], this->ids[k]);
    }
  }
};

bool isFinite(const Vec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// One cell after the other, in memory that is used again.
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

  void cut(std::size_t cell, Out& out)
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
        put(out, bad, bad, bad);
      }
    }
    else if (this->Kind == CellKind::Strips)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        const std::int32_t* p = &this->Shape.ids[k];
        put(out, p[k % 2], p[1 - k % 2], p[2]);
      }
    }
    else if (count == 1)
    {
      this->Shape.fan(out);
    }
    else
    {
      this->Shape.findNormal();
      this->Shape.isConvex() ? this->Shape.fan(out) : this->Shape.cutEars(out);
    }
  }

private:
  /// False if a point is wrong (-1) or not finite.
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
};
}

void triangulate(const CellSpan& cells, CellKind kind, const TupleSpan& points,
  std::int64_t firstCell, const Parallel& parallel, TriangleList& list)
{
  const std::size_t count = cells.offsets.size > 0 ? cells.offsets.size - 1 : 0;
  const std::size_t chunks = (count + cellsPerChunk - 1) / cellsPerChunk;
  const auto endOf = [&](std::size_t chunk)
  { return std::min(count, (chunk + 1) * cellsPerChunk); };
  std::vector<Cutter> cutters(parallel.workers(), Cutter(cells, kind, points));

  // 1. Where the triangles of each chunk of cells begin.
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

  // 2. Each chunk into its own place.
  forEach(parallel, 0, chunks,
    [&](int worker, std::size_t chunk)
    {
      Out out = list.corners.data() + 3 * first[chunk];
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
