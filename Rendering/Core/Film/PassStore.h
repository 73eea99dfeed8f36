// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief writes values to the passes of an image
 */
#ifndef lambent_PassStore_h
#define lambent_PassStore_h

#include "Image.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambent
{
/// The same bits for every NaN, since processors produce different ones.
template <typename Value>
Value canonical(double value)
{
  return std::isnan(value) ? std::numeric_limits<Value>::quiet_NaN() : static_cast<Value>(value);
}

/// Calls body(address) with the address of a pixel's first component, of the pass's type.
template <typename Body>
void atPixel(const Pass& pass, std::size_t pixel, Body&& body)
{
  const std::size_t first = pixel * static_cast<std::size_t>(pass.components);
  pass.isDouble ? body(static_cast<double*>(pass.data) + first)
                : body(static_cast<float*>(pass.data) + first);
}

/// Stores one component of a pixel.
inline void storeValue(const Pass& pass, std::size_t pixel, int component, double value)
{
  atPixel(pass, pixel,
    [&](auto* to) { to[component] = canonical<std::remove_pointer_t<decltype(to)>>(value); });
}

/// Stores NaN in all components of some pixels.
inline void storeNothing(const Pass& pass, std::size_t pixel, int count)
{
  atPixel(pass, pixel,
    [&](auto* to)
    {
      using Value = std::remove_pointer_t<decltype(to)>;
      std::fill_n(to, static_cast<std::size_t>(count) * pass.components,
        std::numeric_limits<Value>::quiet_NaN());
    });
}
}

#endif
