// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the backends that vtkSMPTools was built with
 *
 * TBB is omitted under the thread sanitizer. Its library, which distributes the work, is not
 * compiled with the sanitizer, so every memory access of a worker would look like a race.
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
