// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ThreadedParallel_h
#define ThreadedParallel_h

#include "Parallel.h"

#include <thread>
#include <vector>

/// Runs each worker in its own thread.
class ThreadedParallel : public lambent::Parallel
{
public:
  explicit ThreadedParallel(int workers)
    : Count(workers)
  {
  }

  int workers() const override { return this->Count; }

  void run(const std::function<void(int)>& body) const override
  {
    std::vector<std::thread> threads;
    for (int worker = 0; worker < this->Count; ++worker)
    {
      threads.emplace_back([&body, worker]() { body(worker); });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  }

private:
  int Count;
};

#endif
