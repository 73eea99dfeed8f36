// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the channels of neighbouring pixels, which are not owned
 */
#ifndef lambent_ChannelSpan_h
#define lambent_ChannelSpan_h

#include <cstddef>

namespace lambent
{
/// Red, green, blue and perhaps alpha. The values of a channel are consecutive; the channels begin
/// `stride` values apart. This fits into registers; an array of pointers would be read from memory.
struct ChannelSpan
{
  const double* first;
  std::size_t stride;

  const double* operator[](int channel) const
  {
    return this->first + static_cast<std::size_t>(channel) * this->stride;
  }
};
}

#endif
