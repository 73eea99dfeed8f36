// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ColorTable.h"

#include "Elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lambent
{
ColorTable::ColorTable(
  Entry entries, std::size_t count, double low, double high, bool isLogarithmic)
  : Entries(entries)
  , Count(count)
  , IsLogarithmic(isLogarithmic)
  , Low(this->scaled(low))
  , High(this->scaled(high))
  , Below(entries)
  , Above(entries + 4 * (count - 1))
  , NotANumber(entries)
{
  // VTK's lookup tables treat such a narrow range as empty, too.
  const auto intervals = static_cast<double>(count);
  const double width = this->High - this->Low;
  const bool isEmpty = width < std::numeric_limits<double>::min() * intervals;
  this->Factor = isEmpty ? 0.0 : intervals / width;
}

double ColorTable::scaled(double value) const
{
  return this->IsLogarithmic ? decimalLogarithm(value) : value;
}

ColorTable::Entry ColorTable::entry(double value) const
{
  if (std::isnan(value))
  {
    return this->NotANumber;
  }
  if (this->IsLogarithmic && !(value > 0.0))
  {
    return this->Entries; // as in VTK, the lower end of the range, not below it
  }
  const double place = this->scaled(value);
  if (place < this->Low)
  {
    return this->Below;
  }
  if (place > this->High)
  {
    return this->Above;
  }
  const auto index = static_cast<std::size_t>((place - this->Low) * this->Factor);
  return this->Entries + 4 * std::min(index, this->Count - 1);
}
}
