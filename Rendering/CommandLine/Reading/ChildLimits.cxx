// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ChildLimits.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LAMBENT_LIMIT_MEMORY 0 // the sanitizers' own maps exceed any memory
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LAMBENT_LIMIT_MEMORY 0
#endif
#endif
#ifndef LAMBENT_LIMIT_MEMORY
#define LAMBENT_LIMIT_MEMORY 1
#endif

namespace lambent::command
{
namespace
{

namespace fs = std::filesystem;

/// The total size of all files in a folder and its subfolders; empty if there are too many files.
std::optional<std::uintmax_t> SizeOfFolder(const fs::path& folder)
{
  constexpr int mostFiles = 10000;
  std::uintmax_t size = 0;
  int files = 0;
  std::error_code error;
  fs::recursive_directory_iterator entry(
    folder, fs::directory_options::skip_permission_denied, error);
  while (!error && entry != fs::recursive_directory_iterator())
  {
    if (++files > mostFiles)
    {
      return std::nullopt;
    }
    std::error_code none;
    const std::uintmax_t bytes = entry->is_regular_file(none) ? entry->file_size(none) : 0;
    size += none ? 0 : bytes;
    entry.increment(error);
  }
  return size;
}

std::uintmax_t MemoryOfMachine()
{
  const long pages = sysconf(_SC_PHYS_PAGES);
  return pages > 0 ? static_cast<std::uintmax_t>(pages) * static_cast<std::uintmax_t>(getpagesize())
                   : 0;
}

/// The memory that already counts against RLIMIT_DATA; 0 if the system does not say.
std::uintmax_t MemoryInUse()
{
  std::uintmax_t pages[6] = {}; // size, resident, shared, text, lib, data
  std::ifstream file("/proc/self/statm");
  for (std::uintmax_t& count : pages)
  {
    file >> count;
  }
  return file ? pages[5] * static_cast<std::uintmax_t>(getpagesize()) : 0;
}

void Limit(int resource, std::uintmax_t most)
{
  rlimit limit;
  if (getrlimit(resource, &limit) == 0 && most < limit.rlim_cur)
  {
    limit.rlim_cur = static_cast<rlim_t>(most); // the hard limit of CPU time would raise SIGKILL
    setrlimit(resource, &limit);
  }
}

} // namespace

ChildLimits LimitsFor(const std::string& path, bool hasParts)
{
  std::error_code error;
  std::optional<std::uintmax_t> size = fs::file_size(path, error);
  if (hasParts)
  {
    const fs::path folder = fs::path(path).parent_path();
    size = SizeOfFolder(folder.empty() ? "." : folder);
  }
  ChildLimits limits;
  limits.memory = MemoryOfMachine();
  if (size)
  {
    limits.seconds = static_cast<unsigned long>(10 + *size / 100000);
    limits.memory = std::min(limits.memory, (std::uintmax_t{ 2 } << 30) + 256 * *size);
  }
  return limits;
}

void TakeLimits(const ChildLimits& limits)
{
  Limit(RLIMIT_CORE, 0);
  if (limits.seconds > 0)
  {
    Limit(RLIMIT_CPU, limits.seconds);
  }
  if (LAMBENT_LIMIT_MEMORY && limits.memory > 0)
  {
    // The threads' stacks count too.
    const std::uintmax_t stacks =
      (std::uintmax_t{ 16 } << 20) * std::thread::hardware_concurrency();
    Limit(RLIMIT_DATA, MemoryInUse() + stacks + limits.memory);
  }
}

} // namespace lambent::command
