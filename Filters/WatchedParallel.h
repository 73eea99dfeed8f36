// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief VTK's threads for a filter that tells its progress and can be aborted
 */
#ifndef WatchedParallel_h
#define WatchedParallel_h

#include "Abort.h"
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

  /// Small work has many checkpoints: not each becomes a ProgressEvent.
  void checkpoint(double done) const override
  {
    constexpr double step = 0.002;
    if (!(done >= this->Told && done < this->Told + step))
    {
      this->Told = done;
      this->Filter->UpdateProgress(done);
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
  mutable double Told = -1.0;
};
}

#endif
