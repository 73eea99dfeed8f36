// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "FillKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "FillKernel.h"

#include <cstdint>
#include <hwy/cache_control.h>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace hn = hwy::HWY_NAMESPACE;

namespace
{
constexpr std::size_t cacheLine = 64;

/// Only whole cache lines are streamed.
template <typename Value>
void fill(Value* to, std::size_t count)
{
  const Value value = std::numeric_limits<Value>::quiet_NaN();
  const hn::CappedTag<Value, cacheLine / sizeof(Value)> d;
  const auto vector = hn::Set(d, value);
  Value* const end = to + count;
  while (to < end && reinterpret_cast<std::uintptr_t>(to) % cacheLine != 0)
  {
    *to++ = value;
  }
  for (Value* next; (next = to + cacheLine / sizeof(Value)) <= end;)
  {
    for (; to < next; to += hn::Lanes(d))
    {
      hn::Stream(vector, d, to);
    }
  }
  while (to < end)
  {
    *to++ = value;
  }
}

void FillFloats(float* to, std::size_t count)
{
  fill(to, count);
}

void FillDoubles(double* to, std::size_t count)
{
  fill(to, count);
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(FillFloats);
HWY_EXPORT(FillDoubles);

void fillWithNaN(float* to, std::size_t count)
{
  HWY_DYNAMIC_DISPATCH(FillFloats)(to, count);
}

void fillWithNaN(double* to, std::size_t count)
{
  HWY_DYNAMIC_DISPATCH(FillDoubles)(to, count);
}

void finishFilling()
{
  hwy::FlushStream();
}
}
#endif
