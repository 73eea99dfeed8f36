// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief read-only views of the caller's arrays: tuples, numbers, indices, cells
 *
 * A span points to memory that the caller keeps alive. Nothing is copied or written.
 */
#ifndef lambent_Spans_h
#define lambent_Spans_h

#include "Arithmetic.h"

#include <cstddef>
#include <cstdint>

namespace lambent
{
/// Contiguous three-component tuples of float or double.
struct TupleSpan
{
  const void* data = nullptr;
  bool isDouble = false;
  std::size_t size = 0;

  explicit operator bool() const { return this->data != nullptr; }

  /// The address of tuple i.
  const char* at(std::size_t i) const
  {
    return static_cast<const char*>(this->data) + (this->isDouble ? 24 : 12) * i;
  }

  Vec3 operator[](std::size_t i) const
  {
    if (this->isDouble)
    {
      const double* p = static_cast<const double*>(this->data) + 3 * i;
      return { p[0], p[1], p[2] };
    }
    const float* p = static_cast<const float*>(this->data) + 3 * i;
    return { p[0], p[1], p[2] };
  }
};

/// Contiguous numbers of float or double.
struct ScalarSpan
{
  const void* data = nullptr;
  bool isDouble = false;
  std::size_t size = 0;

  explicit operator bool() const { return this->data != nullptr; }

  double operator[](std::size_t i) const
  {
    return this->isDouble ? static_cast<const double*>(this->data)[i]
                          : static_cast<const float*>(this->data)[i];
  }
};

/// Indices of 32 or 64 bits. A negative index becomes larger than any valid one.
struct IndexSpan
{
  const void* data = nullptr;
  bool is64Bit = false;
  std::size_t size = 0;

  /// The address of index i.
  const char* at(std::size_t i) const
  {
    return static_cast<const char*>(this->data) + (this->is64Bit ? 8 : 4) * i;
  }

  std::uint64_t operator[](std::size_t i) const
  {
    return this->is64Bit
      ? static_cast<std::uint64_t>(static_cast<const std::int64_t*>(this->data)[i])
      : static_cast<std::uint64_t>(
          static_cast<std::int64_t>(static_cast<const std::int32_t*>(this->data)[i]));
  }
};

/// Cell k has the points connectivity[offsets[k]] to connectivity[offsets[k + 1] - 1].
struct CellSpan
{
  IndexSpan offsets; ///< one more than the number of cells
  IndexSpan connectivity;
};
}

#endif
