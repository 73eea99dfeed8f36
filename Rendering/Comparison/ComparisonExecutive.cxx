// SPDX-FileCopyrightText: Copyright (c) the Lambent authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ComparisonExecutive.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkLambentImageComparison::Executive);

vtkTypeBool vtkLambentImageComparison::Executive::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  auto* const comparison = vtkLambentImageComparison::SafeDownCast(this->GetAlgorithm());
  const int comparisonsBefore = comparison ? comparison->NumberOfComparisons : 0;
  const vtkMTimeType dataTimeBefore = this->DataTime.GetMTime();
  const vtkTypeBool result = this->Superclass::ProcessRequest(request, inputs, outputs);
  vtkMTimeType now = 0;
  if (!comparison || !this->ComputePipelineMTime(request, inputs, outputs, -1, &now))
  {
    return result;
  }
  const bool isCompared = comparison->NumberOfComparisons != comparisonsBefore;
  // If the execution was aborted, the data time changes without a comparison.
  if (!isCompared && (!result || this->DataTime.GetMTime() != dataTimeBefore))
  {
    this->FailureTime = now;
  }
  if (now <= this->FailureTime)
  {
    comparison->Fail("there is nothing to compare, since an input could not be updated");
    return 0; // so that downstream filters stop, too
  }
  if (!isCompared && now > this->DataTime.GetMTime())
  {
    comparison->Fail("nothing has been compared since an input or a setting changed");
  }
  return result;
}

vtkExecutive* vtkLambentImageComparison::CreateDefaultExecutive()
{
  return Executive::New();
}
