// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief the executive of vtkLambentImageComparison, which keeps its results current
 *
 * When an input fails, a pipeline stops before it reaches the algorithm, and the algorithm's
 * results would stay those of an earlier request. Every request passes through
 * ProcessRequest() of the executive, whichever method and whichever filter downstream made it.
 * So the results are discarded here unless the request led to a comparison or left nothing to
 * compare anew.
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

  /// When the pipeline was last changed before a failed pass. VTK takes such a pass for done
  /// until there is another change, and goes on with what is left of the data.
  vtkMTimeType FailureTime = 0;
};

#endif
