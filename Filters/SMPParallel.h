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

#include <algorithm>

/// As many workers as vtkSMPTools has threads, on whatever backend is in use.
class SMPParallel : public lambent::Parallel
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
  const int Count = std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads());
};

#endif
