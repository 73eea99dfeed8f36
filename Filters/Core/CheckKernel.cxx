// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// Compiled once for each instruction set: foreach_target.h includes this file again.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "CheckKernel.cxx"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "CheckKernel.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;

// The arrays are read only once, faster than the hardware prefetches.
constexpr std::size_t ahead = 512;

template <typename Id>
OffsetKinds classify(const Id* offsets, std::size_t cells)
{
  constexpr hn::ScalableTag<Id> tag;
  const std::size_t lanes = hn::Lanes(tag);
  const auto three = hn::Set(tag, Id(3));
  auto descending = hn::Lt(three, three);
  auto triangles = hn::Eq(three, three);
  std::size_t i = 0;
  for (; i + lanes <= cells; i += lanes)
  {
    hwy::Prefetch(offsets + i + ahead);
    const auto begin = hn::LoadU(tag, offsets + i);
    const auto end = hn::LoadU(tag, offsets + i + 1);
    descending = hn::Or(descending, hn::Lt(end, begin));
    triangles = hn::And(triangles, hn::Eq(hn::Sub(end, begin), three));
  }
  OffsetKinds kinds{ hn::AllFalse(tag, descending), hn::AllTrue(tag, triangles) };
  for (; i < cells; ++i)
  {
    kinds.areAscending = kinds.areAscending && offsets[i + 1] >= offsets[i];
    // The difference could overflow, but not between ascending offsets from 0 on.
    kinds.areOfTriangles = kinds.areOfTriangles && offsets[i] >= 0 &&
      offsets[i + 1] >= offsets[i] && offsets[i + 1] - offsets[i] == 3;
  }
  return kinds;
}

template <typename Id>
IdRange rangeOf(const Id* ids, std::size_t count)
{
  constexpr hn::ScalableTag<Id> tag;
  const std::size_t lanes = hn::Lanes(tag);
  auto first = hn::Set(tag, ids[0]);
  auto last = first;
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
  {
    hwy::Prefetch(ids + i + ahead);
    const auto some = hn::LoadU(tag, ids + i);
    first = hn::Min(first, some);
    last = hn::Max(last, some);
  }
  IdRange range{ hn::GetLane(hn::MinOfLanes(tag, first)), hn::GetLane(hn::MaxOfLanes(tag, last)) };
  for (; i < count; ++i)
  {
    range.first = std::min<std::int64_t>(range.first, ids[i]);
    range.last = std::max<std::int64_t>(range.last, ids[i]);
  }
  return range;
}

template <typename Number>
bool finite(const Number* values, std::size_t count)
{
  constexpr hn::ScalableTag<Number> tag;
  const std::size_t lanes = hn::Lanes(tag);
  const auto zero = hn::Zero(tag);
  auto are = hn::Eq(zero, zero);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
  {
    // Zero times an infinity or NaN is NaN, which equals nothing.
    are = hn::And(are, hn::Eq(hn::Mul(zero, hn::LoadU(tag, values + i)), zero));
  }
  return hn::AllTrue(tag, are) &&
    std::all_of(values + i, values + count, [](Number value) { return std::isfinite(value); });
}

OffsetKinds Classify32(const std::int32_t* offsets, std::size_t cells)
{
  return classify(offsets, cells);
}

OffsetKinds Classify64(const std::int64_t* offsets, std::size_t cells)
{
  return classify(offsets, cells);
}

IdRange FindRange32(const std::int32_t* ids, std::size_t count)
{
  return rangeOf(ids, count);
}

IdRange FindRange64(const std::int64_t* ids, std::size_t count)
{
  return rangeOf(ids, count);
}

bool AreFinite32(const float* values, std::size_t count)
{
  return finite(values, count);
}

bool AreFinite64(const double* values, std::size_t count)
{
  return finite(values, count);
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(Classify32);
HWY_EXPORT(Classify64);
HWY_EXPORT(FindRange32);
HWY_EXPORT(FindRange64);
HWY_EXPORT(AreFinite32);
HWY_EXPORT(AreFinite64);

OffsetKinds classifyOffsets(const std::int32_t* offsets, std::size_t cells)
{
  return HWY_DYNAMIC_DISPATCH(Classify32)(offsets, cells);
}

OffsetKinds classifyOffsets(const std::int64_t* offsets, std::size_t cells)
{
  return HWY_DYNAMIC_DISPATCH(Classify64)(offsets, cells);
}

IdRange findRange(const std::int32_t* ids, std::size_t count)
{
  return HWY_DYNAMIC_DISPATCH(FindRange32)(ids, count);
}

IdRange findRange(const std::int64_t* ids, std::size_t count)
{
  return HWY_DYNAMIC_DISPATCH(FindRange64)(ids, count);
}

bool areFinite(const float* values, std::size_t count)
{
  return HWY_DYNAMIC_DISPATCH(AreFinite32)(values, count);
}

bool areFinite(const double* values, std::size_t count)
{
  return HWY_DYNAMIC_DISPATCH(AreFinite64)(values, count);
}
}
#endif
