// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief store the lanes of a vector that a mask selects, without gaps
 *
 * Each target includes this header once, hence the toggled guard.
 */
#if defined(lambent_AppendLanes_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_AppendLanes_h
#undef lambent_AppendLanes_h
#else
#define lambent_AppendLanes_h
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
/// Stores the selected 32-bit lanes at out, which must have room for a whole vector. Returns how
/// many were selected.
template <typename Tag>
int appendLanes(Tag tag, hwy::HWY_NAMESPACE::Vec<Tag> values, hwy::HWY_NAMESPACE::Mask<Tag> mask,
  std::uint32_t* out)
{
  namespace hn = hwy::HWY_NAMESPACE;
#if HWY_TARGET <= HWY_AVX3
  hn::StoreU(hn::Compress(values, mask), tag, out);
  return static_cast<int>(hn::CountTrue(tag, mask));
#else
  // Where no instruction compresses lanes, Highway shuffles them by a table, which GCC copies to
  // the stack each time.
  if (hn::AllFalse(tag, mask))
  {
    return 0;
  }
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(tag, mask, bits);
  HWY_ALIGN std::uint32_t lanes[hn::MaxLanes(tag)];
  hn::Store(values, tag, lanes);
  int count = 0;
  for (std::size_t lane = 0; lane < hn::MaxLanes(tag); ++lane)
  {
    out[count] = lanes[lane];
    count += bits[lane / 8] >> lane % 8 & 1;
  }
  return count;
#endif
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
