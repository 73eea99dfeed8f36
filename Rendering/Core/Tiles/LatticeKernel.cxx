// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "LatticeKernel.cxx"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "AppendLanes.h"
#include "VectorFrame.h"

#include "LatticeKernel.h"

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
using Halves = hn::Rebind<std::uint16_t, D>;

void loadPoints(const double* from, V& x, V& y, V& z)
{
  hn::LoadInterleaved3(d, from, x, y, z);
}

void loadPoints(const float* from, V& x, V& y, V& z)
{
  const hn::Rebind<float, D> df;
  hn::Vec<hn::Rebind<float, D>> fx, fy, fz;
  hn::LoadInterleaved3(df, from, fx, fy, fz);
  x = hn::PromoteTo(d, fx);
  y = hn::PromoteTo(d, fy);
  z = hn::PromoteTo(d, fz);
}

/// PointLattice::position(), if u is not NaN.
hn::Vec<Halves> position(const PointLattice::Axis& axis, V u, int shift)
{
  const hn::Rebind<std::int32_t, D> di;
  const V zero = hn::Zero(d), last = hn::Set(d, axis.count), margin = hn::Set(d, axis.margin);
  const V left = hn::Min(hn::Max(hn::Sub(u, margin), zero), last);
  const V right = hn::Min(hn::Max(hn::Add(hn::Add(u, margin), hn::Set(d, 1.0)), zero), last);
  const auto first = hn::DemoteTo(di, hn::Ceil(left));
  const auto end = hn::DemoteTo(di, right);
  const auto roundUp = hn::Set(di, (1 << shift) - 1);
  return hn::DemoteTo(Halves(),
    hn::Add(hn::ShiftRightSame(first, shift), hn::ShiftRightSame(hn::Add(end, roundUp), shift)));
}

template <typename Coordinate>
void locate(const PointLattice& lattice, const TupleSpan& points, std::size_t begin,
  std::size_t end, LatticePosition* positions)
{
  const VectorFrame frame(lattice.frame());
  const auto* coordinates = static_cast<const Coordinate*>(points.data);
  const V infinity = hn::Set(d, std::numeric_limits<double>::infinity());
  std::size_t p = begin;
  for (; p + lanes <= end && lattice.isPrecise(); p += lanes)
  {
    V x, y, z;
    loadPoints(coordinates + 3 * p, x, y, z);
    const FrameVector v = frame.toFrame(x, y, z);
    const V perUnit = hn::Div(hn::Set(d, lattice.samplesPerUnit()), v.w);
    const V column = hn::Add(hn::Mul(v.x, perUnit), hn::Set(d, lattice.columns().origin));
    const V row = hn::Add(hn::Mul(v.y, perUnit), hn::Set(d, lattice.rows().origin));
    hn::StoreInterleaved2(position(lattice.columns(), column, lattice.shift()),
      position(lattice.rows(), row, lattice.shift()), Halves(), &positions[p].column);
    const M isPlaced = hn::And(hn::And(hn::Gt(v.w, hn::Zero(d)), hn::Lt(hn::Abs(v.z), infinity)),
      hn::And(hn::Eq(column, column), hn::Eq(row, row)));
    if (!hn::AllTrue(d, isPlaced))
    {
      for (std::size_t k = p; k < p + lanes; ++k)
      {
        positions[k] = lattice.locate(points[k]);
      }
    }
  }
  for (; p < end; ++p)
  {
    positions[p] = lattice.locate(points[p]);
  }
}

void LocatePoints(const PointLattice& lattice, const TupleSpan& points, std::size_t begin,
  std::size_t end, LatticePosition* positions)
{
  points.isDouble ? locate<double>(lattice, points, begin, end, positions)
                  : locate<float>(lattice, points, begin, end, positions);
}

hn::Vec<hn::Rebind<std::uint32_t, D>> narrowed(hn::Vec<hn::Rebind<std::uint64_t, D>> ids)
{
  return hn::TruncateTo(hn::Rebind<std::uint32_t, D>(), ids);
}

hn::Vec<hn::Rebind<std::uint32_t, D>> narrowed(hn::Vec<hn::Rebind<std::uint32_t, D>> ids)
{
  return ids;
}

/// Reads the indices [begin, end) as 32 bits. There are many, each read once, and the prefetching
/// of the processor does not keep up.
template <typename Index>
bool readCorners(const IndexSpan& corners, std::size_t begin, std::size_t end,
  std::size_t pointCount, std::int32_t offset, std::int32_t* out)
{
  constexpr std::size_t ahead = 4096 / sizeof(Index);
  const hn::Rebind<Index, D> from;
  const hn::Rebind<std::uint32_t, D> to;
  const auto* ids = static_cast<const Index*>(corners.data);
  const auto last = hn::Set(from, static_cast<Index>(pointCount - 1));
  const auto offsets = hn::Set(to, static_cast<std::uint32_t>(offset));
  auto wrong = hn::Gt(hn::Zero(from), hn::Zero(from));
  std::size_t k = begin;
  for (; k + lanes <= end; k += lanes)
  {
    hwy::Prefetch(ids + k + ahead);
    const auto id = hn::LoadU(from, ids + k);
    wrong = hn::Or(wrong, hn::Gt(id, last));
    hn::StoreU(
      hn::Add(narrowed(id), offsets), to, reinterpret_cast<std::uint32_t*>(out + (k - begin)));
  }
  bool isSound = hn::AllFalse(from, wrong);
  for (; k < end; ++k)
  {
    isSound = isSound && ids[k] < pointCount;
    out[k - begin] = static_cast<std::int32_t>(ids[k]) + offset;
  }
  return isSound;
}

bool AddCorners(const IndexSpan& corners, std::size_t begin, std::size_t end,
  std::size_t pointCount, std::int32_t offset, LatticeBoxes& boxes)
{
  std::int32_t* const out = boxes.corners + 3 * boxes.count;
  const bool isSound = corners.is64Bit
    ? readCorners<std::uint64_t>(corners, 3 * begin, 3 * end, pointCount, offset, out)
    : readCorners<std::uint32_t>(corners, 3 * begin, 3 * end, pointCount, offset, out);
  boxes.count += isSound ? static_cast<int>(end - begin) : 0;
  return isSound;
}

#if HWY_TARGET == HWY_SCALAR
// One triangle at a time: here, lanes of 32 bits cannot be cast to pairs of 16.
void FindBoxes(const LatticePosition* positions, LatticeBoxes& boxes)
{
  boxes.found = boxes.unplaced = 0;
  for (int k = 0; k < boxes.count; ++k)
  {
    const LatticePosition a = positions[boxes.corners[3 * k]];
    const LatticePosition b = positions[boxes.corners[3 * k + 1]];
    const LatticePosition c = positions[boxes.corners[3 * k + 2]];
    const auto first = [](int p, int q, int r)
    { return static_cast<std::uint16_t>(std::min(p, std::min(q, r)) >> 1); };
    const auto end = [](int p, int q, int r)
    { return static_cast<std::uint16_t>((std::max(p, std::max(q, r)) + 1) >> 1); };
    boxes.first[k] = { first(a.column, b.column, c.column), first(a.row, b.row, c.row) };
    boxes.end[k] = { end(a.column, b.column, c.column), end(a.row, b.row, c.row) };
    boxes.isInexact[k] = (a.column | b.column | c.column | a.row | b.row | c.row) & 1;
    if (std::max(a.column, std::max(b.column, c.column)) >= LatticePosition::notFinite)
    {
      boxes.unplacedTriangles[boxes.unplaced++] = static_cast<std::uint32_t>(k);
    }
    else if (boxes.first[k].column < boxes.end[k].column && boxes.first[k].row < boxes.end[k].row)
    {
      boxes.triangles[boxes.found++] = static_cast<std::uint32_t>(k);
    }
  }
}
#else
// The two halves of a position share one lane of 32 bits.
using Pairs = hn::CappedTag<std::uint32_t, 16>;
using PairIndices = hn::RebindToSigned<Pairs>;
using PairHalves = hn::Repartition<std::uint16_t, Pairs>;

/// Looks up the positions of the corners of some triangles: a, b and c of each. Gather instructions
/// are faster than loads with AVX-512 only.
void lookUp(const std::uint32_t* pairs, const std::int32_t* corners, hn::Vec<Pairs>& a,
  hn::Vec<Pairs>& b, hn::Vec<Pairs>& c)
{
  const Pairs dp;
  const PairIndices di;
  if constexpr (HWY_TARGET <= HWY_AVX3)
  {
    hn::Vec<PairIndices> ia, ib, ic;
    hn::LoadInterleaved3(di, corners, ia, ib, ic);
    a = hn::GatherIndex(dp, pairs, ia);
    b = hn::GatherIndex(dp, pairs, ib);
    c = hn::GatherIndex(dp, pairs, ic);
  }
  else
  {
    std::uint32_t found[3 * hn::MaxLanes(dp)];
    for (std::size_t k = 0; k < 3 * hn::Lanes(dp); ++k)
    {
      found[k] = pairs[corners[k]];
    }
    hn::LoadInterleaved3(dp, found, a, b, c);
  }
}

void FindBoxes(const LatticePosition* positions, LatticeBoxes& boxes)
{
  static_assert(LatticeBoxes::capacity % hn::MaxLanes(Pairs()) == 0, "no vector sticks out");
  const Pairs dp;
  const PairIndices di;
  const PairHalves dh;
  const auto* pairs = reinterpret_cast<const std::uint32_t*>(positions);
  const auto isOne = hn::Set(dp, 0xFFFFFFFFu), ones = hn::Set(dp, 0x00010001u);
  const auto columnBits = hn::Set(dp, 0xFFFFu);
  boxes.found = boxes.unplaced = 0;
  const auto step = static_cast<int>(hn::Lanes(dp));
  // The last vector may look up more triangles than there are; any valid point will do.
  std::fill(boxes.corners + 3 * boxes.count,
    boxes.corners + std::min(3 * (boxes.count + step), 3 * LatticeBoxes::capacity), 0);
  for (int k = 0; k < boxes.count; k += step)
  {
    hn::Vec<Pairs> pa, pb, pc;
    lookUp(pairs, boxes.corners + 3 * k, pa, pb, pc);
    const auto a = hn::BitCast(dh, pa), b = hn::BitCast(dh, pb), c = hn::BitCast(dh, pc);
    const auto smallest = hn::Min(hn::Min(a, b), c), largest = hn::Max(hn::Max(a, b), c);
    const auto first = hn::ShiftRight<1>(smallest);
    const auto end = hn::ShiftRight<1>(hn::Add(largest, hn::Set(dh, 1)));
    const auto hasSamples = hn::Eq(hn::BitCast(dp, hn::VecFromMask(dh, hn::Lt(first, end))), isOne);
    // If a position is unplaced, both halves say so. Test the column.
    const auto unplaced = hn::Gt(
      hn::And(hn::BitCast(dp, largest), columnBits), hn::Set(dp, LatticePosition::notFinite - 1u));
    const auto isUsed = hn::Lt(hn::Iota(di, k), hn::Set(di, boxes.count));
    const auto used = hn::RebindMask(dp, isUsed);
    const auto keep = hn::AndNot(unplaced, hn::And(hasSamples, used));
    const auto numbers = hn::BitCast(dp, hn::Iota(di, k));
    const auto inexact = hn::And(hn::BitCast(dp, hn::Or(hn::Or(a, b), c)), ones);
    hn::StoreU(hn::BitCast(dp, first), dp, reinterpret_cast<std::uint32_t*>(boxes.first + k));
    hn::StoreU(hn::BitCast(dp, end), dp, reinterpret_cast<std::uint32_t*>(boxes.end + k));
    hn::StoreU(inexact, dp, boxes.isInexact + k);
    boxes.found += appendLanes(dp, numbers, keep, boxes.triangles + boxes.found);
    const auto aside = hn::And(unplaced, used);
    if (!hn::AllFalse(dp, aside))
    {
      boxes.unplaced += appendLanes(dp, numbers, aside, boxes.unplacedTriangles + boxes.unplaced);
    }
  }
}
#endif
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(LocatePoints);
HWY_EXPORT(AddCorners);
HWY_EXPORT(FindBoxes);

void locatePoints(const PointLattice& lattice, const TupleSpan& points, std::size_t begin,
  std::size_t end, LatticePosition* positions)
{
  HWY_DYNAMIC_DISPATCH(LocatePoints)(lattice, points, begin, end, positions);
}

bool addCorners(const IndexSpan& corners, std::size_t begin, std::size_t end,
  std::size_t pointCount, std::int32_t offset, LatticeBoxes& boxes)
{
  return HWY_DYNAMIC_DISPATCH(AddCorners)(corners, begin, end, pointCount, offset, boxes);
}

void findBoxes(const LatticePosition* positions, LatticeBoxes& boxes)
{
  HWY_DYNAMIC_DISPATCH(FindBoxes)(positions, boxes);
}
}
#endif
