// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Compiled once for each instruction set: foreach_target.h includes this file again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "NormalKernel.cxx"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorAngles.h"

#include "NormalKernel.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
constexpr bool hasWeights(Weighting weighting)
{
  return weighting == Weighting::Angle || weighting == Weighting::Max;
}

/**
 * A buffer of triangles between the passes of add(). In a single pass, the long dependency
 * chain from the points to the sums (square root, division, polynomial) would stall the
 * processor: it cannot look far enough ahead to start on the next triangles. In the short
 * loop of each pass it can.
 */
template <typename Coordinate>
struct alignas(64) Batch
{
  static constexpr std::size_t capacity = 64;

  std::size_t count = 0;
  /// The indices of the corners' sums.
  alignas(64) std::int64_t places[3][capacity];
  /// The coordinates of the corners.
  alignas(64) Coordinate points[9][capacity];
  /// A corner's term is the direction, times its weight if the weighting has one.
  alignas(64) PointSum directions[capacity];
  alignas(64) double weights[3][capacity];

  Vector3 point(int corner, std::size_t k) const
  {
    const auto load = [&](int axis) {
      return toDouble(hn::Load(hn::Rebind<Coordinate, D>(), this->points[3 * corner + axis] + k));
    };
    return { load(0), load(1), load(2) };
  }

  /// Stores zeros for triangles without area.
  void storeDirection(std::size_t k, const Vector3& v, M isUsed)
  {
    hn::StoreInterleaved4(hn::IfThenElseZero(isUsed, v.x), hn::IfThenElseZero(isUsed, v.y),
      hn::IfThenElseZero(isUsed, v.z), hn::Zero(d), d, &this->directions[k].x);
  }
  void storeWeights(std::size_t k, const Vector3& weight, M isUsed)
  {
    hn::Store(hn::IfThenElseZero(isUsed, weight.x), d, this->weights[0] + k);
    hn::Store(hn::IfThenElseZero(isUsed, weight.y), d, this->weights[1] + k);
    hn::Store(hn::IfThenElseZero(isUsed, weight.z), d, this->weights[2] + k);
  }
};

/// contributeTriangle()
template <Weighting weighting, typename Coordinate>
void contribute(std::size_t k, Batch<Coordinate>& batch)
{
  const Vector3 a = batch.point(0, k), b = batch.point(1, k), c = batch.point(2, k);
  const Vector3 ab = b - a, ac = c - a, bc = c - b;
  const Vector3 area = cross(ab, ac);
  const V square = dot(area, area);
  const M isUsed = isUsable(square);
  if constexpr (weighting == Weighting::Area)
  {
    batch.storeDirection(k, area, isUsed);
  }
  else if constexpr (weighting == Weighting::Uniform)
  {
    batch.storeDirection(k, area * inverse(hn::Sqrt(square)), isUsed);
  }
  else if constexpr (weighting == Weighting::Angle)
  {
    const V areaLength = hn::Sqrt(square);
    batch.storeDirection(k, area * inverse(areaLength), isUsed);
    batch.storeWeights(
      k, anglesOf(areaLength, dot(ab, ac), hn::Neg(dot(ab, bc)), dot(ac, bc)), isUsed);
  }
  else
  {
    const V abSquare = dot(ab, ab), bcSquare = dot(bc, bc), acSquare = dot(ac, ac);
    batch.storeDirection(k, area, isUsed);
    batch.storeWeights(k,
      { inverse(hn::Mul(abSquare, acSquare)), inverse(hn::Mul(bcSquare, abSquare)),
        inverse(hn::Mul(acSquare, bcSquare)) },
      isUsed);
  }
}

/// sum += direction * weight
template <bool isWeighted>
void add(PointSum& sum, const PointSum& direction, const double& weight)
{
  constexpr hn::CappedTag<double, 4> tag;
  double* values = &sum.x;
  for (std::size_t k = 0; k < 4; k += hn::MaxLanes(tag))
  {
    auto term = hn::Load(tag, &direction.x + k);
    if constexpr (isWeighted)
    {
      term = hn::Mul(term, hn::Set(tag, weight));
    }
    hn::Store(hn::Add(hn::Load(tag, values + k), term), tag, values + k);
  }
}

template <Weighting weighting, typename Coordinate>
void finish(Batch<Coordinate>& batch, PointSum* sums)
{
  for (std::size_t k = 0; k < batch.count; k += lanes)
  {
    contribute<weighting>(k, batch);
  }
  for (std::size_t k = 0; k < batch.count; ++k)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      add<hasWeights(weighting)>(
        sums[batch.places[corner][k]], batch.directions[k], batch.weights[corner][k]);
    }
  }
  batch.count = 0;
}

/// The point ids of the corners of several triangles.
struct Corners
{
  I a, b, c;
};

Corners load(const std::int64_t* corners)
{
  Corners result{ I(), I(), I() };
  hn::LoadInterleaved3(di, corners, result.a, result.b, result.c);
  return result;
}

Corners load(const std::int32_t* corners)
{
  hn::Vec<DI32> a, b, c;
  hn::LoadInterleaved3(di32, corners, a, b, c);
  return { hn::PromoteTo(di, a), hn::PromoteTo(di, b), hn::PromoteTo(di, c) };
}

/// PointSums::place()
class Places
{
public:
  explicit Places(const PointSums& sums)
    : Begin(hn::Set(di, sums.begin()))
    , Outside(hn::Set(di, static_cast<std::int64_t>(sums.size())))
  {
  }

  I operator()(I points) const
  {
    const I place = hn::Sub(points, this->Begin);
    const auto isInside = hn::AndNot(hn::Lt(place, hn::Zero(di)), hn::Lt(place, this->Outside));
    return hn::IfThenElse(isInside, place, this->Outside);
  }

  bool areOutside(I a, I b, I c) const
  {
    return hn::AllTrue(di, hn::Eq(hn::Min(hn::Min(a, b), c), this->Outside));
  }

private:
  I Begin, Outside;
};

template <Weighting weighting, typename Coordinate, typename Id>
std::size_t add(const Coordinate* points, const Id* corners, std::size_t count, PointSums& sums)
{
  const Places places(sums);
  const std::size_t end = count - count % lanes;
  Batch<Coordinate> batch;
  for (std::size_t k = 0; k < end; k += lanes)
  {
    const Id* ids = corners + 3 * k;
    const Corners named = load(ids);
    const I a = places(named.a), b = places(named.b), c = places(named.c);
    if (places.areOutside(a, b, c))
    {
      continue;
    }
    hn::Store(a, di, batch.places[0] + batch.count);
    hn::Store(b, di, batch.places[1] + batch.count);
    hn::Store(c, di, batch.places[2] + batch.count);
    // Gather instructions are slower.
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        hwy::Prefetch(sums.data() + batch.places[corner][batch.count + lane]);
        const Coordinate* point = points + 3 * ids[3 * lane + corner];
        batch.points[3 * corner][batch.count + lane] = point[0];
        batch.points[3 * corner + 1][batch.count + lane] = point[1];
        batch.points[3 * corner + 2][batch.count + lane] = point[2];
      }
    }
    batch.count += lanes;
    if (batch.count == Batch<Coordinate>::capacity)
    {
      finish<weighting>(batch, sums.data());
    }
  }
  finish<weighting>(batch, sums.data());
  return end;
}

template <typename Coordinate, typename Id>
std::size_t add(Weighting weighting, const Coordinate* points, const Id* corners, std::size_t count,
  PointSums& sums)
{
  switch (weighting)
  {
    case Weighting::Uniform:
      return add<Weighting::Uniform>(points, corners, count, sums);
    case Weighting::Area:
      return add<Weighting::Area>(points, corners, count, sums);
    case Weighting::Angle:
      return add<Weighting::Angle>(points, corners, count, sums);
    case Weighting::Max:
      return add<Weighting::Max>(points, corners, count, sums);
  }
  return 0;
}

template <typename Id>
std::size_t add(Weighting weighting, const TupleSpan& points, const Id* corners, std::size_t count,
  PointSums& sums)
{
  return points.isDouble
    ? add(weighting, static_cast<const double*>(points.data), corners, count, sums)
    : add(weighting, static_cast<const float*>(points.data), corners, count, sums);
}

std::size_t Add32(Weighting weighting, const TupleSpan& points, const std::int32_t* corners,
  std::size_t count, PointSums& sums)
{
  return add(weighting, points, corners, count, sums);
}

std::size_t Add64(Weighting weighting, const TupleSpan& points, const std::int64_t* corners,
  std::size_t count, PointSums& sums)
{
  return add(weighting, points, corners, count, sums);
}

std::size_t WriteNormals(const PointSum* sums, std::size_t count, float sign, float* normals)
{
  const V signs = hn::Set(d, static_cast<double>(sign));
  const std::size_t end = count - count % lanes;
  for (std::size_t k = 0; k < end; k += lanes)
  {
    Vector3 sum{ V(), V(), V() };
    V unused;
    hn::LoadInterleaved4(d, &sums[k].x, sum.x, sum.y, sum.z, unused);
    const V square = dot(sum, sum);
    const M isUsed = isUsable(square);
    const Vector3 unit = sum * inverse(hn::Sqrt(square));
    const auto round = [&](V value)
    { return hn::DemoteTo(df, hn::IfThenElseZero(isUsed, hn::Mul(signs, value))); };
    hn::StoreInterleaved3(round(unit.x), round(unit.y), round(unit.z), df, normals + 3 * k);
  }
  return end;
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(Add32);
HWY_EXPORT(Add64);
HWY_EXPORT(WriteNormals);

std::size_t addTriangles(Weighting weighting, const TupleSpan& points, const std::int32_t* corners,
  std::size_t count, PointSums& sums)
{
  return HWY_DYNAMIC_DISPATCH(Add32)(weighting, points, corners, count, sums);
}

std::size_t addTriangles(Weighting weighting, const TupleSpan& points, const std::int64_t* corners,
  std::size_t count, PointSums& sums)
{
  return HWY_DYNAMIC_DISPATCH(Add64)(weighting, points, corners, count, sums);
}

std::size_t writeNormals(const PointSum* sums, std::size_t count, float sign, float* normals)
{
  return HWY_DYNAMIC_DISPATCH(WriteNormals)(sums, count, sign, normals);
}
}
#endif
