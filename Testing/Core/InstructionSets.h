// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef InstructionSets_h
#define InstructionSets_h

#include "VectorTarget.h"

#include <gtest/gtest.h>

/// Calls test() with each instruction set, "plain" first.
template <typename Test>
void onAllTargets(const Test& test)
{
  const std::string usual = lambent::vectorTargetInUse();
  for (const std::string& target : lambent::vectorTargets())
  {
    SCOPED_TRACE(target);
    ASSERT_TRUE(lambent::useVectorTarget(target));
    test();
  }
  ASSERT_TRUE(lambent::useVectorTarget(usual));
}

#endif
