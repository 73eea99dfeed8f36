// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads decimal numbers from text in memory, exactly and fast
 *
 * Most numbers in mesh files have at most 15 digits and a small exponent. Their
 * digits as an integer and the power of ten are both exact in binary64, so that
 * one multiplication or division rounds correctly. All other numbers go through
 * the standard library. No function here depends on the locale of the process,
 * unless the library has no std::from_chars for double.
 *
 * Reference: W. D. Clinger, "How to Read Floating Point Numbers Accurately", 1990.
 */

#ifndef TextNumber_h
#define TextNumber_h

#include <cstdint>

namespace lambent::command
{

/// Reads [+-]digits[.digits][e[+-]digits], or inf or nan in any case. Returns what follows the
/// number, or `at` if there is none. `end` must point to a zero byte. Too large numbers become
/// infinite, too small ones zero.
const char* ReadNumber(const char* at, const char* end, double& value);

/// Reads [+-]digits. Returns what follows, or `at` if there is no integer. Numbers beyond 64 bits
/// become the largest or smallest of 64 bits.
const char* ReadInteger(const char* at, std::int64_t& value);

} // namespace lambent::command

#endif
