// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ThreadLimit_h
#define ThreadLimit_h

#include "vtkSMPTools.h"

#include <tbb/global_control.h>

/// As long as it lives, VTK and TBB (with it Embree) have that many threads.
class ThreadLimit
{
public:
  explicit ThreadLimit(int threads, int afterwards = 0)
    : Afterwards(afterwards)
    , Control(tbb::global_control::max_allowed_parallelism, threads)
  {
    vtkSMPTools::Initialize(threads);
  }
  ~ThreadLimit() { vtkSMPTools::Initialize(this->Afterwards); }
  ThreadLimit(const ThreadLimit&) = delete;
  void operator=(const ThreadLimit&) = delete;

private:
  const int Afterwards;
  tbb::global_control Control;
};

#endif
