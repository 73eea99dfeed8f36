// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief asks the system for large pages, which cost less to touch for the first time
 *
 * The first access to each page of fresh memory interrupts the program. With pages of 2 MB instead
 * of 4 kB, this takes a quarter of the time.
 */
#ifndef lambent_HugePages_h
#define lambent_HugePages_h

#include <cstddef>
#include <cstdint>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace lambent
{
constexpr std::size_t hugePageSize = 2 * 1024 * 1024;

/// Advises the system to use large pages for memory that has not been written yet. Does nothing for
/// small sizes, and on systems other than Linux.
inline void useHugePages([[maybe_unused]] void* data, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  constexpr std::uintptr_t page = 4096;
  if (bytes >= hugePageSize)
  {
    const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(data);
    const std::uintptr_t begin = (address + page - 1) / page * page;
    const std::uintptr_t end = (address + bytes) / page * page;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
  }
#endif
}
}

#endif
