// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include <fstream>
#include <malloc.h>
#include <stdexcept>

namespace
{
/// A line of /proc/self/status, in bytes.
double status(const std::string& name)
{
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
  {
    if (line.compare(0, name.size() + 1, name + ":") == 0)
    {
      return 1024.0 * std::stod(line.substr(name.size() + 1));
    }
  }
  throw std::runtime_error("/proc/self/status has no " + name);
}
}

double peakMemory(const Contest& contest, double imageBytes)
{
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5"; // Reset the peak that making the mesh has left.
  const double before = status("VmRSS");
  contest.run();
  return status("VmHWM") - before - imageBytes;
}
