// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief colours of a surface that come from data at its points or cells
 */
#ifndef lambent_ColorArray_h
#define lambent_ColorArray_h

#include "AttributeSpan.h"
#include "ColorTable.h"

#include <cmath>
#include <cstddef>

namespace lambent
{
/**
 * Without a table, the values are colours: one component is grey, two are grey and alpha, three are
 * red, green and blue, four also have alpha. Bytes are divided by 255; other numbers are taken as
 * they are. With a table, a number is looked up for each tuple. Where alpha is used, it multiplies
 * the opacity of the surface.
 */
struct ColorArray
{
  /// Instead of a component: the length of the tuple, sqrt(v0^2 + v1^2 + ...), summed in order.
  static constexpr int magnitude = -1;

  AttributeSpan values;
  const ColorTable* table = nullptr;
  int component = 0; ///< that is looked up, or magnitude
  /// Whether numbers at points are interpolated first, and looked up at each hit. Otherwise the
  /// colours at the points are interpolated. Only with a table and values at points.
  bool isMappedLast = false;
  /// Whether alpha is used: that of the values, or of the table. Otherwise colours are opaque.
  bool hasAlpha = false;

  /// The number to look up.
  double number(std::size_t tuple) const
  {
    return this->values.visit([&](const auto* all) { return this->numberIn(all, tuple); });
  }

  /// The colour of a point or cell.
  Vec3 color(std::size_t tuple) const
  {
    return this->values.visit([&](const auto* all) { return this->colorIn(all, tuple); });
  }

  /// The alpha of a point or cell.
  double alpha(std::size_t tuple) const
  {
    return this->values.visit([&](const auto* all) { return this->alphaIn(all, tuple); });
  }

  /// The same, where `all` are the values with their own type.
  template <typename Value>
  double numberIn(const Value* all, std::size_t tuple) const
  {
    const Value* const numbers = all + tuple * static_cast<std::size_t>(this->values.components);
    if (this->component != magnitude)
    {
      return static_cast<double>(numbers[this->component]);
    }
    double sum = 0.0;
    for (int k = 0; k < this->values.components; ++k)
    {
      const auto number = static_cast<double>(numbers[k]);
      sum += number * number;
    }
    return std::sqrt(sum);
  }
  template <typename Value>
  Vec3 colorIn(const Value* all, std::size_t tuple) const
  {
    if (this->table)
    {
      return this->table->color(this->numberIn(all, tuple));
    }
    const Value* const channels = all + tuple * static_cast<std::size_t>(this->values.components);
    const int green = this->values.components < 3 ? 0 : 1, blue = 2 * green;
    return { channelOf(channels[0]), channelOf(channels[green]), channelOf(channels[blue]) };
  }
  template <typename Value>
  double alphaIn(const Value* all, std::size_t tuple) const
  {
    const int components = this->values.components;
    if (!this->hasAlpha)
    {
      return 1.0;
    }
    if (this->table)
    {
      return this->table->alpha(this->numberIn(all, tuple));
    }
    return components % 2 == 0
      ? channelOf(all[(tuple + 1) * static_cast<std::size_t>(components) - 1])
      : 1.0;
  }
};
}

#endif
