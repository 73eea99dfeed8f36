// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief interpret the bytes of a fuzzer as choices and numbers
 *
 * Each call consumes bytes from the front. So a changed byte changes one value, and inserted
 * or removed bytes change the values after them. When no bytes are left, every value is zero.
 * The meaning of a corpus file depends only on this file and its target, not on the compiler
 * or the version of libFuzzer.
 */
#ifndef FuzzInput_h
#define FuzzInput_h

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

/// Aborts the process, like a crash, if a condition does not hold.
inline void require(bool holds, const char* what)
{
  if (!holds)
  {
    std::fprintf(stderr, "What must hold does not: %s\n", what);
    std::abort();
  }
}

class FuzzInput
{
public:
  FuzzInput(const std::uint8_t* data, std::size_t size)
    : At(data)
    , End(data + size)
  {
  }

  bool empty() const { return this->At == this->End; }
  std::uint8_t byte() { return this->empty() ? std::uint8_t{ 0 } : *this->At++; }
  bool flag() { return (this->byte() & 1) != 0; }
  /// A number from 0 to count - 1, from one byte; count is at most 256.
  int choice(int count) { return this->byte() % count; }
  /// True for `cases` of the 256 values of a byte.
  bool seldom(int cases = 8) { return this->byte() > 255 - cases; }

  template <typename T>
  T raw()
  {
    T value{};
    const auto left = static_cast<std::size_t>(this->End - this->At);
    const std::size_t size = left < sizeof(T) ? left : sizeof(T);
    std::memcpy(&value, this->At, size);
    this->At += size;
    return value;
  }

  /// A number in [low, high], in 255 steps.
  double within(double low, double high) { return low + (high - low) * (this->byte() / 255.0); }

  /// Any double, but often a critical value.
  double number()
  {
    using Limits = std::numeric_limits<double>;
    static const double special[] = { 0.0, -0.0, 1.0, -1.0, 0.5, 2.0, 1e-10, 1e7, -1e7, 1e20, 1e50,
      -1e50, 1e-50, 1e150, 1e-150, 1e308, 1e-308, 30.0, 90.0, 180.0, -90.0, 1e16,
      static_cast<double>(std::numeric_limits<float>::max()), Limits::min(), Limits::denorm_min(),
      -Limits::denorm_min(), Limits::epsilon(), Limits::max(), Limits::lowest(), Limits::infinity(),
      -Limits::infinity(), Limits::quiet_NaN() };
    const int kind = this->byte();
    if (kind < 96)
    {
      return (kind - 48) / 16.0;
    }
    if (kind < 160)
    {
      return this->raw<std::int16_t>() / 8192.0;
    }
    if (kind < 208)
    {
      const double previous = this->Previous;
      return this->Previous = std::nextafter(previous, kind & 1 ? 2.0 : -2.0);
    }
    if (kind < 224)
    {
      return this->Previous;
    }
    return this->Previous = kind < 240
      ? special[this->choice(static_cast<int>(sizeof(special) / sizeof(special[0])))]
      : kind < 248 ? this->raw<double>()
                   : static_cast<double>(this->raw<float>());
  }

private:
  const std::uint8_t* At;
  const std::uint8_t* End;
  double Previous = 1.0;
};

#endif
