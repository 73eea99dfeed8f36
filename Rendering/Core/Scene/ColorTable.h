// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a table of colours for numbers, as vtkLookupTable has it
 *
 * The range is divided into as many equal intervals as there are entries. A number v in it has the
 * colour of entry floor((v - low) * (count / (high - low))), but at most the last; where the range
 * is empty, it has the first. On a logarithmic scale, v and both ends of the range are replaced by
 * their decimal logarithms (decimalLogarithm()). Numbers below and above the range, and NaN,
 * have colours of their own.
 */
#ifndef lambent_ColorTable_h
#define lambent_ColorTable_h

#include "Arithmetic.h"

#include <cstddef>
#include <cstdint>

namespace lambent
{
/// A channel of a colour. Bytes are divided by 255; the quotients are looked up, because a division
/// takes several times as long. Other numbers are taken as they are.
template <typename Number>
double channelOf(Number number)
{
  return static_cast<double>(number);
}
inline double channelOf(unsigned char byte)
{
  struct Channels
  {
    double values[256];
    constexpr Channels()
      : values()
    {
      for (int k = 0; k < 256; ++k)
      {
        this->values[k] = k / 255.0;
      }
    }
  };
  static constexpr Channels channels;
  return channels.values[byte];
}

class ColorTable
{
public:
  using Entry = const unsigned char*; ///< red, green, blue, alpha

  /// The table has `count` entries of four bytes, at least one, which must outlive it. The range
  /// must be finite, with low <= high, and greater than 0 on a logarithmic scale.
  ColorTable(Entry entries, std::size_t count, double low, double high, bool isLogarithmic);

  /// Colours of numbers outside the range; by default those of the first and the last entry.
  void setBelow(Entry color) { this->Below = color; }
  void setAbove(Entry color) { this->Above = color; }
  /// By default, the colour of the first entry.
  void setNotANumber(Entry color) { this->NotANumber = color; }

  Entry entry(double value) const;
  Vec3 color(double value) const
  {
    const Entry entry = this->entry(value);
    return { channelOf(entry[0]), channelOf(entry[1]), channelOf(entry[2]) };
  }

  double alpha(double value) const { return channelOf(this->entry(value)[3]); }

private:
  double scaled(double value) const;

  Entry Entries;
  std::size_t Count;
  bool IsLogarithmic;
  double Low, High; ///< logarithms on a logarithmic scale
  double Factor;    ///< entries per unit
  Entry Below, Above, NotANumber;
};
}

#endif
