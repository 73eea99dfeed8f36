// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief limits on the CPU time and memory of a reader
 *
 * With a broken file, a reader may run for ever, or exhaust the machine's memory and take other
 * programs down. Both limits are far above what any reader was seen to need. They grow with the
 * size of the file, or of all files in its folder if it names others.
 */

#ifndef ChildLimits_h
#define ChildLimits_h

#include <cstdint>
#include <string>

namespace lambent::command
{

struct ChildLimits
{
  /// CPU seconds: 10, plus 10 for each megabyte. 0: no limit.
  unsigned long seconds = 0;
  /// Bytes beyond those in use: 2 GiB, plus 256 for each byte of the file; at most the memory of
  /// the machine. 0: no limit.
  std::uintmax_t memory = 0;
};

/// The limits for reading a file. If it names others and its folder has too many files to count,
/// the memory of the machine is the only limit.
ChildLimits LimitsFor(const std::string& path, bool hasParts);

/// Applies the limits to this process: allocations beyond them fail, and SIGXCPU ends the process.
/// Also disables core dumps.
void TakeLimits(const ChildLimits& limits);

} // namespace lambent::command

#endif
