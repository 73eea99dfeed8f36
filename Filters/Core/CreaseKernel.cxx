// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Compiled once for each instruction set: foreach_target.h includes this file again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "CreaseKernel.cxx"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorLengths.h"

#include "Creases.h"

#include <algorithm>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// A buffer of triangles between the passes (see NormalKernel.cxx): their corners, the normals
/// there, and the indices of the marks.
template <typename Coordinate>
struct Batch
{
  static constexpr std::size_t capacity = 32;

  /// x, y, z and padding for each corner of each triangle.
  alignas(64) Coordinate points[3][4 * capacity];
  alignas(64) float normals[3][4 * capacity];
  std::size_t places[3][capacity];
  std::size_t count = 0;

  template <typename Value>
  static Vector3 load(const Value (&row)[4 * capacity], std::size_t k)
  {
    constexpr hn::Rebind<Value, D> tag;
    hn::Vec<decltype(tag)> x, y, z, unused;
    hn::LoadInterleaved4(tag, row + 4 * k, x, y, z, unused);
    return { toDouble(x), toDouble(y), toDouble(z) };
  }
};

/// Reads the corners of triangles from memory.
template <typename Coordinate, typename Id>
class Source
{
public:
  Source(const Coordinate* points, const Id* corners, const Creases& creases)
    : Points(points)
    , Corners(corners)
    , Normals(creases.normals.data())
    , Begin(creases.begin())
    , Size(creases.size())
  {
  }

  /// Adds a triangle, unless all of its corners lie outside the range of points.
  void add(std::size_t triangle, Batch<Coordinate>& batch) const
  {
    const std::size_t k = batch.count;
    bool isAnyInside = false;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Id id = this->Corners[3 * triangle + corner];
      const std::size_t place = this->place(id);
      isAnyInside |= place < this->Size;
      batch.places[corner][k] = place;
      std::memcpy(batch.points[corner] + 4 * k, this->Points + 3 * static_cast<std::size_t>(id),
        3 * sizeof(Coordinate));
      std::memcpy(batch.normals[corner] + 4 * k, this->Normals + 3 * place, 3 * sizeof(float));
    }
    batch.count += isAnyInside;
  }

  void prefetch(std::size_t triangle) const
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const Id id = this->Corners[3 * triangle + corner];
      hwy::Prefetch(this->Points + 3 * static_cast<std::size_t>(id));
      hwy::Prefetch(this->Normals + 3 * this->place(id));
    }
  }

private:
  std::size_t place(Id id) const
  {
    return std::min(static_cast<std::size_t>(id - this->Begin), this->Size);
  }

  const Coordinate* Points;
  const Id* Corners;
  const float* Normals;
  std::int64_t Begin;
  std::size_t Size;
};

/// isSteep() at the corners of the triangles of a batch.
template <typename Coordinate>
void finish(Batch<Coordinate>& batch, Creases& creases)
{
  const V squaredCosine = hn::Set(d, creases.squaredCosine);
  for (std::size_t k = 0; k < batch.count; k += lanes)
  {
    const Vector3 a = batch.load(batch.points[0], k);
    const Vector3 area =
      cross(batch.load(batch.points[1], k) - a, batch.load(batch.points[2], k) - a);
    const V square = dot(area, area);
    const V least = hn::Mul(squaredCosine, square);
    const M isUsed = isUsable(square);
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const V along = dot(area, batch.load(batch.normals[corner], k));
      const M isEven = hn::And(hn::Gt(along, hn::Zero(d)), hn::Ge(hn::Mul(along, along), least));
      const M isSteep = hn::AndNot(isEven, isUsed);
      if (hn::AllFalse(d, isSteep))
      {
        continue;
      }
      HWY_ALIGN double steep[lanes];
      hn::Store(hn::IfThenElseZero(isSteep, hn::Set(d, 1.0)), d, steep);
      for (std::size_t lane = 0; lane < lanes && k + lane < batch.count; ++lane)
      {
        creases.marks[batch.places[corner][k + lane]] |= steep[lane] != 0.0;
      }
    }
  }
  batch.count = 0;
}

template <typename Coordinate, typename Id>
void mark(const Coordinate* points, const Id* corners, std::size_t count, Creases& creases)
{
  constexpr std::size_t ahead = 12;
  const Source<Coordinate, Id> source(points, corners, creases);
  Batch<Coordinate> batch{}; // unused lanes are computed, but never marked
  for (std::size_t k = 0; k < count; ++k)
  {
    source.prefetch(std::min(k + ahead, count - 1));
    source.add(k, batch);
    if (batch.count == Batch<Coordinate>::capacity)
    {
      finish(batch, creases);
    }
  }
  finish(batch, creases);
}

template <typename Id>
void mark(const TupleSpan& points, const Id* corners, std::size_t count, Creases& creases)
{
  points.isDouble ? mark(static_cast<const double*>(points.data), corners, count, creases)
                  : mark(static_cast<const float*>(points.data), corners, count, creases);
}

void Mark32(
  const TupleSpan& points, const std::int32_t* corners, std::size_t count, Creases& creases)
{
  mark(points, corners, count, creases);
}

void Mark64(
  const TupleSpan& points, const std::int64_t* corners, std::size_t count, Creases& creases)
{
  mark(points, corners, count, creases);
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(Mark32);
HWY_EXPORT(Mark64);

void markCreases(
  const TupleSpan& points, const std::int32_t* corners, std::size_t count, Creases& creases)
{
  HWY_DYNAMIC_DISPATCH(Mark32)(points, corners, count, creases);
}

void markCreases(
  const TupleSpan& points, const std::int64_t* corners, std::size_t count, Creases& creases)
{
  HWY_DYNAMIC_DISPATCH(Mark64)(points, corners, count, creases);
}
}
#endif
