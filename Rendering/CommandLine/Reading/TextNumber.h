// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief reads decimal numbers from text in memory, exactly and fast
 *
 * Most numbers in mesh files have at most 15 digits and a small exponent. Their digits as an
 * integer and the power of ten are both exact in binary64, so that a single multiplication or
 * division rounds correctly. All other numbers are read by the standard library. No function here
 * depends on the locale of the process, unless the library lacks std::from_chars for double.
 *
 * Reference: W. D. Clinger, "How to Read Floating Point Numbers Accurately", 1990.
 */

#ifndef TextNumber_h
#define TextNumber_h

#include <cstdint>

namespace lambent::command
{

/// Reads [+-]digits[.digits][e[+-]digits], or inf or nan in upper or lower case. Returns the
/// position after the number, or `at` if there is none. `end` must point to a zero byte. Numbers
/// that are too large become infinite, and numbers that are too small become zero.
const char* ReadNumber(const char* at, const char* end, double& value);

/// Reads [+-]digits. Returns the position after them, or `at` if there is no integer. Numbers
/// beyond 64 bits become the largest 64-bit integer, or its negative.
const char* ReadInteger(const char* at, std::int64_t& value);

} // namespace lambent::command

#endif
