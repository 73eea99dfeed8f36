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

template <int ChannelCount>
void store(const ChannelSpan& channels, int count, unsigned char* pixels)
{
  constexpr int size = mostBytePixels;
  HWY_ALIGN std::uint8_t bytes[4][size];
  for (int i = 0; i < size; i += static_cast<int>(lanes))
  {
    for (int channel = 0; channel < ChannelCount; ++channel)
    {
      storeByte(hn::LoadU(d, channels[channel] + i), bytes[channel] + i);
    }
  }
  const hn::CappedTag<std::uint8_t, 16> d8;
  HWY_ALIGN std::uint8_t interleaved[ChannelCount * size];
  for (int i = 0; i < size; i += static_cast<int>(hn::Lanes(d8)))
  {
    const auto red = hn::LoadU(d8, bytes[0] + i), green = hn::LoadU(d8, bytes[1] + i),
               blue = hn::LoadU(d8, bytes[2] + i);
    if constexpr (ChannelCount == 4)
    {
      hn::StoreInterleaved4(red, green, blue, hn::LoadU(d8, bytes[3] + i), d8, interleaved + 4 * i);
    }
    else
    {
      hn::StoreInterleaved3(red, green, blue, d8, interleaved + 3 * i);
    }
  }
  std::memcpy(pixels, interleaved, static_cast<std::size_t>(ChannelCount * count));
}

void StoreBytes(const ChannelSpan& channels, int channelCount, int count, unsigned char* pixels)
{
  channelCount == 4 ? store<4>(channels, count, pixels) : store<3>(channels, count, pixels);
}
}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace lambent
{
HWY_EXPORT(StoreBytes);

void storeBytes(const ChannelSpan& channels, int channelCount, int count, unsigned char* pixels)
{
  HWY_DYNAMIC_DISPATCH(StoreBytes)(channels, channelCount, count, pixels);
}
}
#endif
