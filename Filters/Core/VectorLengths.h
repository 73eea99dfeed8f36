// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief isUsableSquare() for several lengths at a time; conversion of coordinates to double
 *
 * Each target includes this header once, hence the toggled guard.
 */
#if defined(lambent_VectorLengths_h) == defined(HWY_TARGET_TOGGLE)
#ifdef lambent_VectorLengths_h
#undef lambent_VectorLengths_h
#else
#define lambent_VectorLengths_h
#endif

#include "VectorTriples.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace lambent
{
namespace HWY_NAMESPACE
{
namespace
{
using DF = hn::Rebind<float, D>;
constexpr DF df;

inline V toDouble(V value)
{
  return value;
}

inline V toDouble(hn::Vec<DF> value)
{
  return hn::PromoteTo(d, value);
}

inline M isUsable(V square)
{
  return hn::And(hn::Ge(square, hn::Set(d, std::numeric_limits<double>::min())),
    hn::Le(square, hn::Set(d, std::numeric_limits<double>::max())));
}
}
}
}
HWY_AFTER_NAMESPACE();
#endif
