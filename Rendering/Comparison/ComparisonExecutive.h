// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the executive of vtkLambentImageComparison, which keeps its results current
 *
 * When an input fails, the pipeline stops before it reaches the algorithm, which would keep the
 * results of an earlier request. Every request passes through ProcessRequest() of the executive,
 * whichever method or downstream filter made it. So the results are discarded here, unless the
 * request led to a comparison or nothing has changed since the last one.
 */
#ifndef ComparisonExecutive_h
#define ComparisonExecutive_h

#include "vtkLambentImageComparison.h"
#include "vtkStreamingDemandDrivenPipeline.h"

class vtkLambentImageComparison::Executive : public vtkStreamingDemandDrivenPipeline
{
public:
  static Executive* New();
  vtkTypeMacro(Executive, vtkStreamingDemandDrivenPipeline)

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  Executive() = default;
  ~Executive() override = default;

private:
  Executive(const Executive&) = delete;
  void operator=(const Executive&) = delete;

  /// The modification time of the pipeline at the last failed pass. VTK considers such a pass done
  /// until the next change, and continues with stale data.
  vtkMTimeType FailureTime = 0;
};

#endif
