// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the backends that this vtkSMPTools was built with
 *
 * But for TBB under the thread sanitizer: TBB's library, which is not compiled with it, hands
 * the work over, and all that a worker touches then looks like a race.
 */
#ifndef Backends_h
#define Backends_h

#include "Sanitizers.h"

#include "vtkSMP.h" // For VTK_SMP_ENABLE_...

#include <string>
#include <vector>

inline std::vector<std::string> smpBackends()
{
  return
  {
#if VTK_SMP_ENABLE_SEQUENTIAL
    "Sequential",
#endif
#if VTK_SMP_ENABLE_STDTHREAD
      "STDThread",
#endif
#if VTK_SMP_ENABLE_TBB && !LAMBENT_THREAD_SANITIZER
      "TBB",
#endif
#if VTK_SMP_ENABLE_OPENMP
      "OpenMP",
#endif
  };
}

#endif
