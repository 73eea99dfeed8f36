// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's threads for a filter that reports progress and can be aborted
 */
#ifndef WatchedParallel_h
#define WatchedParallel_h

#include "Abort.h"
#include "Pace.h"
#include "SMPParallel.h"

namespace lambent::adapters
{
/// A checkpoint throws this when the filter should stop.
struct Aborted
{
};

class WatchedParallel : public SMPParallel
{
public:
  explicit WatchedParallel(vtkAlgorithm* filter)
    : Filter(filter)
  {
  }

  /// Small work has many checkpoints, so not every one sends a ProgressEvent.
  void checkpoint(double done) const override
  {
    constexpr double step = 0.002;
    const bool isSmallStep = done >= this->Reported && done < this->Reported + step;
    if (!isSmallStep || this->SinceReport.isOver())
    {
      this->Reported = done;
      this->Filter->UpdateProgress(done);
      this->SinceReport = PartClock();
    }
    this->checkAbort();
  }

  void checkAbort() const
  {
    if (isAborted(this->Filter))
    {
      throw Aborted();
    }
  }

private:
  vtkAlgorithm* const Filter;
  mutable double Reported = -1.0;
  mutable PartClock SinceReport;
};
}

#endif
