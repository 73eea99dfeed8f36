// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief a parallel loop over pieces of a range
 */
#ifndef lambent_Chunks_h
#define lambent_Chunks_h

#include "Parallel.h"

#include <algorithm>
#include <cstddef>

namespace lambent
{
inline std::size_t chunkCount(std::size_t count, std::size_t chunkSize)
{
  return (count + chunkSize - 1) / chunkSize;
}

/// Calls body(begin, end) for [0, chunkSize), [chunkSize, 2 chunkSize) and so on up
/// to count, in any order.
template <typename Body>
void forEachChunk(const Parallel& parallel, std::size_t count, std::size_t chunkSize, Body&& body)
{
  forEach(parallel, 0, chunkCount(count, chunkSize),
    [&](int, std::size_t chunk)
    {
      const std::size_t begin = chunk * chunkSize;
      body(begin, std::min(count, begin + chunkSize));
    });
}
}

#endif
