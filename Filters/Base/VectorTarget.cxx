// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VectorTarget.h"

#include <hwy/highway.h>
#include <hwy/targets.h>

#include <atomic>
#include <cstdlib>

namespace lambent
{
namespace
{
const char* const plain = "plain";

std::atomic<bool>& isPlain()
{
  static std::atomic<bool> value{ false };
  return value;
}

bool choose(const std::string& name)
{
  hwy::SetSupportedTargetsForTest(0); // enable all again
  isPlain() = name == plain;
  if (isPlain())
  {
    return true;
  }
  for (std::int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    if (name == hwy::TargetName(target))
    {
      hwy::SetSupportedTargetsForTest(target);
      hwy::GetChosenTarget().Update(hwy::SupportedTargets());
      return true;
    }
  }
  return false;
}

/// Applies LAMBENT_SIMD, once, before any other use of the targets.
void readEnvironment()
{
  static const bool done = []()
  {
    const char* name = std::getenv("LAMBENT_SIMD");
    return name && choose(name);
  }();
  static_cast<void>(done);
}
}

std::vector<std::string> vectorTargets()
{
  const std::string inUse = vectorTargetInUse();
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::string> names{ plain };
  for (std::int64_t target : hwy::SupportedAndGeneratedTargets())
  {
    names.emplace_back(hwy::TargetName(target));
  }
  choose(inUse);
  return names;
}

bool useVectorTarget(const std::string& name)
{
  readEnvironment();
  const std::string before = vectorTargetInUse();
  if (choose(name))
  {
    return true;
  }
  choose(before);
  return false;
}

std::string vectorTargetInUse()
{
  readEnvironment();
  const std::int64_t supported = hwy::SupportedTargets() & HWY_TARGETS;
  return isPlain() ? plain : hwy::TargetName(supported & -supported);
}

bool areVectorsInUse()
{
  readEnvironment();
  return !isPlain();
}
}
