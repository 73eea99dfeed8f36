// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

// This file is compiled once for each instruction set, by including itself.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ByteKernel.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "VectorDoubles.h"

#include "ByteKernel.h"

#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// toByte() in each lane.
void storeByte(V value, std::uint8_t* bytes)
{
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  const V clamped =
    hn::IfThenElseZero(hn::Gt(value, zero), hn::IfThenElse(hn::Lt(value, one), value, one));
  const auto rounded = hn::DemoteTo(
    hn::Rebind<std::int32_t, D>(), hn::Add(hn::Mul(hn::Set(d, 255.0), clamped), hn::Set(d, 0.5)));
  const hn::Rebind<std::uint8_t, D> d8;
  hn::StoreU(hn::DemoteTo(d8, rounded), d8, bytes);
}

void StoreBytes(
  const double* red, const double* green, const double* blue, int count, unsigned char* pixels)
{
  constexpr int size = 32;
  const double* const colors[3] = { red, green, blue };
  HWY_ALIGN std::uint8_t channels[3][size];
  for (int i = 0; i < size; i += static_cast<int>(lanes))
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      storeByte(hn::LoadU(d, colors[channel] + i), channels[channel] + i);
    }
  }
  const hn::CappedTag<std::uint8_t, 16> d8;
  HWY_ALIGN std::uint8_t interleaved[3 * size];
  for (int i = 0; i < size; i += static_cast<int>(hn::Lanes(d8)))
  {
    hn::StoreInterleaved3(hn::LoadU(d8, channels[0] + i), hn::LoadU(d8, channels[1] + i),
      hn::LoadU(d8, channels[2] + i), d8, interleaved + 3 * i);
  }
  std::memcpy(pixels, interleaved, static_cast<std::size_t>(3 * count));
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(StoreBytes);

void storeBytes(
  const double* red, const double* green, const double* blue, int count, unsigned char* pixels)
{
  HWY_DYNAMIC_DISPATCH(StoreBytes)(red, green, blue, count, pixels);
}
}
#endif
