// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ThreadedParallel.h"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace lambent;

TEST(Parallel, EachIsCalledOnce)
{
  for (int workers : { 1, 2, 3, 8 })
  {
    std::vector<std::atomic<int>> calls(1000);
    std::atomic<bool> areWorkersKnown{ true };
    forEach(ThreadedParallel(workers), 10, 1000,
      [&](int worker, std::size_t i)
      {
        ++calls[i];
        if (worker < 0 || worker >= workers)
        {
          areWorkersKnown = false;
        }
      });
    for (std::size_t i = 0; i < calls.size(); ++i)
    {
      EXPECT_EQ(calls[i], i < 10 ? 0 : 1) << i;
    }
    EXPECT_TRUE(areWorkersKnown);
  }
}

// With one worker it is a plain loop, in order.
TEST(Parallel, OneWorkerIsALoop)
{
  std::vector<std::size_t> order;
  forEach(Parallel(), 3, 7,
    [&](int worker, std::size_t i)
    {
      EXPECT_EQ(worker, 0);
      order.push_back(i);
    });
  EXPECT_EQ(order, (std::vector<std::size_t>{ 3, 4, 5, 6 }));
}

TEST(Parallel, NothingToDo)
{
  forEach(ThreadedParallel(3), 5, 5, [](int, std::size_t) { FAIL(); });
}

TEST(Parallel, ExceptionsReachTheCallerAndStopTheWork)
{
  for (int workers : { 1, 4 })
  {
    std::atomic<int> calls{ 0 };
    const auto work = [&]()
    {
      forEach(ThreadedParallel(workers), 0, 1000000,
        [&](int, std::size_t i)
        {
          ++calls;
          if (i == 100)
          {
            throw std::runtime_error("at 100");
          }
        });
    };
    EXPECT_THROW(work(), std::runtime_error);
    EXPECT_GT(calls, 100);
    EXPECT_LT(calls, 1000000);
  }
}
