// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief limit the threads of the peers
 */
#ifndef ThreadLimit_h
#define ThreadLimit_h

#include "vtkSMPTools.h"

#include <tbb/global_control.h>

#include <string>

/// While this object exists, VTK and TBB, and so Embree, use at most that many threads.
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

/// While this object exists, VTK uses one thread. VTK's number of TBB threads is not changed: after
/// a limit of 1, not all threads return to work immediately.
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
