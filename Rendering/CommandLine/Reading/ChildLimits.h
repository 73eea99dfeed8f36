// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief how much time and memory a reader may take
 *
 * A reader that has lost its way goes on for ever, or asks for more memory than
 * the machine has, and takes other programs down with it. Both limits are far
 * above what any reader was seen to need, and grow with the size of the file, or
 * of all files in its folder if it names others.
 */

#ifndef ChildLimits_h
#define ChildLimits_h

#include <cstdint>
#include <string>

namespace lambent::command
{

struct ChildLimits
{
  /// CPU seconds: 10, and 10 for each megabyte. 0: no limit.
  unsigned long seconds = 0;
  /// Bytes beyond those in use: 2 GiB, and 256 for each byte of the file; at most the memory of
  /// the machine. 0: no limit.
  std::uintmax_t memory = 0;
};

/// The limits for reading a file; if it names others and its folder has too many to look at, only
/// the memory of the machine counts.
ChildLimits LimitsFor(const std::string& path, bool hasParts);

/// Holds this process to the limits: beyond them memory is refused, and SIGXCPU ends it. It writes
/// no core dumps either.
void TakeLimits(const ChildLimits& limits);

} // namespace lambent::command

#endif
