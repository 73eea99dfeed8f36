// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief how many threads the peers have
 */
#ifndef ThreadLimit_h
#define ThreadLimit_h

#include "vtkSMPTools.h"

#include <tbb/global_control.h>

#include <string>

/// As long as it lives, VTK and TBB (with it Embree) have at most that many threads.
class ThreadLimit
{
public:
  explicit ThreadLimit(int threads)
    : Control(tbb::global_control::max_allowed_parallelism, threads)
  {
    vtkSMPTools::Initialize(threads);
  }

private:
  const tbb::global_control Control;
};

/// As long as it lives, VTK has one thread. Its number of TBB threads is left alone:
/// after it was 1 once, not all threads take part again at once.
class SequentialVtk
{
public:
  SequentialVtk() { vtkSMPTools::SetBackend("Sequential"); }
  ~SequentialVtk() { vtkSMPTools::SetBackend(this->Before.c_str()); }
  SequentialVtk(const SequentialVtk&) = delete;
  void operator=(const SequentialVtk&) = delete;

private:
  const std::string Before = vtkSMPTools::GetBackend();
};

#endif
