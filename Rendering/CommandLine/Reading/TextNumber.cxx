// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "TextNumber.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <system_error>

namespace lambent::command
{
namespace
{

constexpr double PowersOfTen[] = { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11,
  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
constexpr int LargestExactPower = 22;
constexpr std::uint64_t LargestExactInteger = std::uint64_t{ 1 } << 53;
constexpr int DigitsOf64Bits = 18; // a number of that many nines and one more digit still fits

bool IsDigit(char c)
{
  return c >= '0' && c <= '9';
}

/// The digits of a number without its sign: value = digits * 10^exponent.
struct Decimal
{
  std::uint64_t digits = 0;
  int count = 0; ///< the number of digits without leading zeros
  int exponent = 0;
  bool isNumber = false;
};

const char* TakeDigits(const char* at, Decimal& number, int exponentStep)
{
  for (; IsDigit(*at); ++at)
  {
    number.isNumber = true;
    if (number.count <= DigitsOf64Bits)
    {
      number.digits = 10 * number.digits + static_cast<std::uint64_t>(*at - '0');
      number.exponent += exponentStep;
      number.count += number.digits != 0;
    }
    else
    {
      ++number.count; // too many for the fast path, whatever they are
    }
  }
  return at;
}

/// Returns the position after the number.
const char* TakeDecimal(const char* at, Decimal& number)
{
  at = TakeDigits(at, number, 0);
  if (*at == '.')
  {
    const char* const fraction = TakeDigits(at + 1, number, -1);
    at = number.isNumber ? fraction : at;
  }
  if (number.isNumber && (*at == 'e' || *at == 'E'))
  {
    const char* const sign = at + 1;
    const bool isSigned = *sign == '+' || *sign == '-';
    if (IsDigit(sign[isSigned]))
    {
      std::int64_t exponent = 0;
      at = ReadInteger(sign, exponent);
      // Far beyond the range of a double, however many digits precede the exponent.
      constexpr std::int64_t most = 1000000000;
      number.exponent += static_cast<int>(std::clamp(exponent, -most, most));
    }
  }
  return at;
}

double ByLibrary(const char* begin, const char* end)
{
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
  double value = 0;
  if (std::from_chars(begin, end, value).ec == std::errc())
  {
    return value;
  }
#endif
  // Out of range: infinite or zero. The text at `end` does not continue the number, so strtod()
  // stops there.
  static_cast<void>(end);
  return std::strtod(begin, nullptr);
}

/// Reads inf, infinity, nan and nan(...) in upper or lower case, as strtod() does.
const char* ReadNoDecimal(const char* at, double& value)
{
  if (*at == '\0' || !std::strchr("iInN", *at))
  {
    return at;
  }
  char* end = nullptr;
  value = std::strtod(at, &end);
  return end;
}

} // namespace

const char* ReadNumber(const char* at, const char* end, double& value)
{
  if (at == end)
  {
    return at;
  }
  const bool isNegative = *at == '-';
  const char* const start = at + (isNegative || *at == '+');
  Decimal number;
  const char* behind = TakeDecimal(start, number);
  if (!number.isNumber)
  {
    behind = ReadNoDecimal(start, value);
    if (behind == start)
    {
      return at;
    }
  }
  else if (number.count <= DigitsOf64Bits + 1 && number.digits <= LargestExactInteger &&
    number.exponent >= -LargestExactPower && number.exponent <= LargestExactPower)
  {
    const double digits = static_cast<double>(number.digits);
    value = number.exponent < 0 ? digits / PowersOfTen[-number.exponent]
                                : digits * PowersOfTen[number.exponent];
  }
  else
  {
    value = ByLibrary(start, behind);
  }
  value = isNegative ? -value : value;
  return behind;
}

const char* ReadInteger(const char* at, std::int64_t& value)
{
  const bool isNegative = *at == '-';
  const char* const start = at + (isNegative || *at == '+');
  const char* digit = start;
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
  std::int64_t magnitude = 0;
  for (; IsDigit(*digit); ++digit)
  {
    const std::int64_t next = *digit - '0';
    magnitude = magnitude > (most - next) / 10 ? most : 10 * magnitude + next;
  }
  if (digit == start)
  {
    return at;
  }
  value = isNegative ? -magnitude : magnitude;
  return digit;
}

} // namespace lambent::command
