// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the core's parallel loops on VTK's threads
 */
#ifndef SMPParallel_h
#define SMPParallel_h

#include "Parallel.h"

#include "vtkSMPTools.h"
#include "vtkVersion.h"

#include <algorithm>
#include <string>

#ifdef __unix__
#include <unistd.h>
#endif

namespace lambent::adapters
{
/// One worker for each thread of vtkSMPTools, with any backend.
class SMPParallel : public Parallel
{
public:
  int workers() const override { return this->Count; }

  void run(const std::function<void(int worker)>& body) const override
  {
    vtkSMPTools::For(0, this->Count, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType worker = begin; worker < end; ++worker)
        {
          body(static_cast<int>(worker));
        }
      });
  }

private:
  /// Since VTK 9.3 the backend STDThread keeps a pool of threads. A child process does not
  /// inherit them and would wait for them forever.
  static bool hasLostThreads()
  {
#if defined(__unix__) && VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
    return getpid() != ProcessAtStart && std::string(vtkSMPTools::GetBackend()) == "STDThread";
#else
    return false;
#endif
  }

#ifdef __unix__
  static inline const pid_t ProcessAtStart = getpid();
#endif

  const int Count = hasLostThreads() ? 1 : std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
};
}

#endif
