// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's threads for a filter that reports its progress and can be aborted
 */
#ifndef WatchedParallel_h
#define WatchedParallel_h

#include "Abort.h"
#include "Pace.h"
#include "SMPParallel.h"

namespace lambent::adapters
{
/// What a checkpoint throws when the filter shall stop.
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

  /// Small work has many checkpoints, which do not all become a ProgressEvent.
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
