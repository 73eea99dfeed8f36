// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the float vectors of the casting kernel, one sample per lane
 *
 * Included once for each target, hence the toggled guard.
 */
#if defined(lambent_VectorFloats_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorFloats_h
#undef lambent_VectorFloats_h
#else
#define lambent_VectorFloats_h
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 16>;
constexpr F f;
using Floats = hn::Vec<F>;
using FloatMask = hn::Mask<F>;
using U = hn::RebindToUnsigned<F>;
constexpr U u;
constexpr auto step = static_cast<int>(hn::MaxLanes(F()));

inline FloatMask columnsBefore(Floats i, int end)
{
  return hn::Lt(i, hn::Set(f, static_cast<float>(end)));
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
