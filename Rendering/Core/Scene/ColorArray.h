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
 * they are. With a table, a number is looked up for each tuple.
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

  /// The number to look up.
  double number(std::size_t tuple) const
  {
    if (this->component != magnitude)
    {
      return this->values.at(tuple, this->component);
    }
    double sum = 0.0;
    for (int k = 0; k < this->values.components; ++k)
    {
      const double value = this->values.at(tuple, k);
      sum += value * value;
    }
    return std::sqrt(sum);
  }

  /// The colour of a point or cell.
  Vec3 color(std::size_t tuple) const
  {
    if (this->table)
    {
      return this->table->color(this->number(tuple));
    }
    const bool isGrey = this->values.components < 3;
    return { this->channel(tuple, 0), this->channel(tuple, isGrey ? 0 : 1),
      this->channel(tuple, isGrey ? 0 : 2) };
  }

private:
  double channel(std::size_t tuple, int component) const
  {
    const double value = this->values.at(tuple, component);
    return this->values.type == AttributeType::UInt8 ? value / 255.0 : value;
  }
};
}

#endif
