// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the vectors of doubles that kernels use
 *
 * Each target includes this header once, hence the toggled guard.
 */
#if defined(lambent_VectorDoubles_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorDoubles_h
#undef lambent_VectorDoubles_h
#else
#define lambent_VectorDoubles_h
#endif

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
namespace hn = hwy::HWY_NAMESPACE;

// At most eight doubles.
constexpr std::size_t lanesAtMost = 8;
using D = hn::CappedTag<double, lanesAtMost>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr D d;
constexpr std::size_t lanes = hn::MaxLanes(D());

/// Stores the lanes of a mask, and reads the others to store them again: some processors take
/// much longer for a masked store.
HWY_INLINE void storeWhere(M mask, V values, double* out)
{
  hn::StoreU(hn::IfThenElse(mask, values, hn::LoadU(d, out)), d, out);
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
